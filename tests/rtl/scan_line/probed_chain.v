// The chain of hw/rtl/scan_line with its cells' registers on wires for comparison, cell 0 first.
module probed_chain #(
  parameter CELLS = 8,
  parameter WORD_BITS = 32,
  parameter WORDS = 3,
  parameter PORTS = 1,
  parameter ALU_BITS = 32,
  parameter SHIFT_BITS = 32,
  parameter DEGREE = 1,
  parameter ROOTS = 1,
  parameter CLEAR_CLOCKS = 3
) (
  input wire clk,
  input wire reset,
  input wire [7:0] fault,
  input wire [15:0] pixels,
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
  output wire [31:0] refresh_colour,

  output wire [CELLS*WORD_BITS-1:0] next_f,            // as received by the next cell
  output wire [CELLS*WORD_BITS-1:0] next_a,
  output wire [CELLS*WORD_BITS-1:0] next_aa,
  output wire [CELLS-1:0] carry,                       // carry of the running sum
  output wire [CELLS-1:0] difference_carry,
  output wire [CELLS-1:0] enable,
  output wire [CELLS-1:0] written,
  output wire [CELLS*WORDS*WORD_BITS-1:0] memory,
  output wire [CELLS*F_WORDS*WORD_BITS-1:0] f,
  output wire [CELLS*X_WORDS*WORD_BITS-1:0] x,
  output wire [CELLS*Y_WORDS*WORD_BITS-1:0] y,
  output wire [CELLS-1:0] alu_carry,
  output wire [CELLS-1:0] differs,
  output wire [CELLS-1:0] beyond,
  output wire [CELLS-1:0] negative,
  output wire [CELLS-1:0] negative_x,
  output wire [CELLS*COLOUR_WORDS*WORD_BITS-1:0] held,
  output wire [CELLS*COLOUR_WORDS*WORD_BITS-1:0] shifting
);
`include "cell_control.vh"
  cell_chain #(
    .CELLS(CELLS), .WORD_BITS(WORD_BITS), .WORDS(WORDS), .PORTS(PORTS), .ALU_BITS(ALU_BITS), .SHIFT_BITS(SHIFT_BITS),
    .DEGREE(DEGREE), .ROOTS(ROOTS), .CLEAR_CLOCKS(CLEAR_CLOCKS)
  ) chain (
    .clk(clk), .reset(reset), .fault(fault), .pixels(pixels), .entry_kind(entry_kind),
    .entry_begins_line(entry_begins_line), .entry_background(entry_background), .entry_number(entry_number),
    .entry_words(entry_words), .entry_beats(entry_beats), .entry_f(entry_f), .entry_a(entry_a), .entry_aa(entry_aa),
    .entry_first_source(entry_first_source), .entry_second_source(entry_second_source), .entry_target(entry_target),
    .entry_work_from(entry_work_from), .entry_result(entry_result), .entry_first_move(entry_first_move),
    .entry_second_move(entry_second_move), .entry_function(entry_function), .entry_work_bits(entry_work_bits),
    .entry_opcode(entry_opcode), .entry_linear_width(entry_linear_width), .entry_linear_shift(entry_linear_shift),
    .entry_constant(entry_constant), .refresh_valid(refresh_valid), .refresh_colour(refresh_colour));

  localparam COLOUR_BITS = COLOUR_WORDS * WORD_BITS;
  genvar c, w;
  generate
    for (c = 0; c < CELLS; c = c + 1) begin : pixel
      assign next_f[c*WORD_BITS +: WORD_BITS] = chain.pixel[c].here.next_f;
      assign next_a[c*WORD_BITS +: WORD_BITS] = chain.pixel[c].here.next_a;
      assign next_aa[c*WORD_BITS +: WORD_BITS] = chain.pixel[c].here.next_aa;
      assign carry[c] = chain.pixel[c].here.adder.carry;
      assign enable[c] = chain.pixel[c].here.enabling.enable;
      assign written[c] = chain.pixel[c].here.enabling.written;
      assign f[c*F_WORDS*WORD_BITS +: F_WORDS*WORD_BITS] = chain.pixel[c].here.register_f.value;
      assign x[c*X_WORDS*WORD_BITS +: X_WORDS*WORD_BITS] = chain.pixel[c].here.register_x.value;
      assign y[c*Y_WORDS*WORD_BITS +: Y_WORDS*WORD_BITS] = chain.pixel[c].here.register_y.value;
      assign alu_carry[c] = chain.pixel[c].here.alu.carry;
      assign differs[c] = chain.pixel[c].here.alu.differs;
      assign beyond[c] = chain.pixel[c].here.alu.beyond;
      assign negative[c] = chain.pixel[c].here.alu.negative;
      assign negative_x[c] = chain.pixel[c].here.alu.negative_x;
      assign held[c*COLOUR_BITS +: COLOUR_BITS] = chain.pixel[c].here.refreshing.held;
      assign shifting[c*COLOUR_BITS +: COLOUR_BITS] = chain.pixel[c].here.refreshing.shifting;
      for (w = 0; w < WORDS; w = w + 1) begin : word
        assign memory[(c*WORDS+w)*WORD_BITS +: WORD_BITS] = chain.pixel[c].here.memory.word[w].cells;
      end
      if (DEGREE > 1) begin : squares
        assign difference_carry[c] = chain.pixel[c].here.squares.adder.carry;
      end else begin : no_squares
        assign difference_carry[c] = 1'b0;
      end
    end
  endgenerate
endmodule
