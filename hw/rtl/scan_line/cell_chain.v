`include "faults.vh"

// A chain of CELLS cells (thesis 7.2.2): each clock, a packet's beat enters cell 0 and every beat advances by one cell;
// a line's pixels leave at the refresh port. Ports have the names and meanings of the SystemC in hw/scan_line.
module cell_chain #(
  parameter CELLS = 8,
  parameter WORD_BITS = 32,
  parameter WORDS = 3,
  parameter PORTS = 1,
  parameter ALU_BITS = 32,
  parameter SHIFT_BITS = 32,
  parameter DEGREE = 1,
  parameter ROOTS = 1,                       // 0: no root instructions
  parameter CLEAR_CLOCKS = 3
) (
  input wire clk,
  input wire reset,
`ifdef CSGSIM_PLANTED_FAULTS
  /* verilator lint_off UNUSEDSIGNAL */
  input wire [7:0] fault,
  /* verilator lint_on UNUSEDSIGNAL */
`endif
  input wire [15:0] pixels,                  // pixels of a line, 1 to CELLS; constant while the chain is in use
  // The beat that enters; fields are described in cell_sequencer.v.
  input wire [1:0] entry_kind,
  input wire entry_begins_line,
  input wire entry_background,
  input wire [15:0] entry_number,
  input wire [15:0] entry_words,
  input wire [15:0] entry_beats,
  input wire [WORD_BITS-1:0] entry_f,
  input wire [WORD_BITS-1:0] entry_a,
  input wire [WORD_BITS-1:0] entry_aa,
  input wire [63:0] entry_first_source,
  input wire [63:0] entry_second_source,
  input wire [63:0] entry_target,
  input wire [15:0] entry_work_from,
  input wire [15:0] entry_result,
  input wire [31:0] entry_first_move,
  input wire [31:0] entry_second_move,
  input wire [2:0] entry_function,
  input wire [15:0] entry_work_bits,
  input wire [5:0] entry_opcode,
  input wire [15:0] entry_linear_width,
  input wire [15:0] entry_linear_shift,
  input wire [31:0] entry_constant,
  output wire refresh_valid,
  output wire [31:0] refresh_colour
);
`include "cell_control.vh"
  localparam CLEARS_AT_ONCE = CLEAR_CLOCKS * PORTS < WORDS;
  localparam COLOUR_BITS = COLOUR_WORDS * WORD_BITS;

  // Beat in each cell; the last entry is the beat that leaves the chain.
  /* verilator lint_off UNUSEDSIGNAL */
  wire [(CELLS+1)*CONTROL_BITS-1:0] control;
  wire [(CELLS+1)*WORD_BITS-1:0] f;
  wire [(CELLS+1)*WORD_BITS-1:0] a;
  wire [(CELLS+1)*WORD_BITS-1:0] aa;
  wire [(CELLS+1)*PORTS*WORD_BITS-1:0] constant;
  wire [CELLS-1:0] enable;
  /* verilator lint_on UNUSEDSIGNAL */
  assign f[0 +: WORD_BITS] = entry_f;
  assign a[0 +: WORD_BITS] = entry_a;
  assign aa[0 +: WORD_BITS] = entry_aa;

  cell_sequencer #(
    .WORD_BITS(WORD_BITS), .WORDS(WORDS), .PORTS(PORTS), .ALU_BITS(ALU_BITS), .SHIFT_BITS(SHIFT_BITS), .ROOTS(ROOTS),
    .CLEARS_AT_ONCE(CLEARS_AT_ONCE)
  ) sequencer (
    .clk(clk), .reset(reset), .kind(entry_kind), .begins_line(entry_begins_line), .background(entry_background),
    .number(entry_number), .words(entry_words), .beats(entry_beats), .first_source(entry_first_source),
    .second_source(entry_second_source), .target(entry_target), .work_from(entry_work_from), .result(entry_result),
    .first_move(entry_first_move), .second_move(entry_second_move), .operation(entry_function),
    .work_bits(entry_work_bits), .opcode(entry_opcode), .linear_width(entry_linear_width),
    .linear_shift(entry_linear_shift), .constant(entry_constant), .control(control[0 +: CONTROL_BITS]),
    .constant_words(constant[0 +: PORTS*WORD_BITS]));

  wire transfers;
  wire lost = CELLS > 2 && `CELL_FAULT(`FAULT_HANDED_ON);
  wire [(CELLS+1)*COLOUR_BITS-1:0] shifting;
  assign shifting[CELLS*COLOUR_BITS +: COLOUR_BITS] = {COLOUR_BITS{1'b0}};
  genvar c;
  generate
    for (c = 0; c < CELLS; c = c + 1) begin : pixel
      scan_line_cell #(
        .WORD_BITS(WORD_BITS), .WORDS(WORDS), .PORTS(PORTS), .ALU_BITS(ALU_BITS), .SHIFT_BITS(SHIFT_BITS),
        .DEGREE(DEGREE), .ROOTS(ROOTS), .CLEARS_AT_ONCE(CLEARS_AT_ONCE)
      ) here (
        .clk(clk), .reset(reset), .control(control[c*CONTROL_BITS +: CONTROL_BITS]), .f(f[c*WORD_BITS +: WORD_BITS]),
        .a(a[c*WORD_BITS +: WORD_BITS] & ~{WORD_BITS{c == 2 && lost}}), .aa(aa[c*WORD_BITS +: WORD_BITS]),
        .constant(constant[c*PORTS*WORD_BITS +: PORTS*WORD_BITS]),
        .next_control(control[(c+1)*CONTROL_BITS +: CONTROL_BITS]), .next_f(f[(c+1)*WORD_BITS +: WORD_BITS]),
        .next_a(a[(c+1)*WORD_BITS +: WORD_BITS]), .next_aa(aa[(c+1)*WORD_BITS +: WORD_BITS]),
        .next_constant(constant[(c+1)*PORTS*WORD_BITS +: PORTS*WORD_BITS]), .transfer(transfers),
        .from_right(shifting[(c+1)*COLOUR_BITS +: COLOUR_BITS]), .shifting(shifting[c*COLOUR_BITS +: COLOUR_BITS]),
        .enable(enable[c]));
    end
  endgenerate

  refresh_path #(.COLOUR_BITS(COLOUR_BITS), .WORD_BITS(WORD_BITS)) refresh (
    .clk(clk), .reset(reset), .pixels(pixels), .holds(control[CC_HOLD]), .background(entry_background),
    .colour_field(entry_first_source[0 +: 48]), .first(shifting[0 +: COLOUR_BITS]), .transfers(transfers),
    .valid(refresh_valid), .colour(refresh_colour));
endmodule
