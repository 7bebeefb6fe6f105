// The pixel processors and memories, which execute one control word per clock, in chips of CHIP pixels (the last may
// have fewer), and the port through which the scan-out reads a memory bit of a row of pixels. Pixel (x, y) is number y
// * WIDTH + x, in chip number / CHIP.
`include "faults.vh"

module pixel_processors #(
  parameter WIDTH = 8,
  parameter HEIGHT = 8,
  parameter CHIP = 64,
  parameter MEMORY_BITS = 72,
  parameter MEMORY_READS = 1,
  parameter ALU_BITS = 1,
  parameter ROOTS = 1,
  parameter CLEAR_CLOCKS = 1,
  parameter OWN_PORT = 0,          // 1: the scan-out has a separate port; 0: it shares the pixels' port
  parameter ADDRESS = 7,
  parameter SIDE = 5
) (
  input wire clk,
  input wire reset,
  input wire [CONTROL_BITS-1:0] early,          // control word of the next clock
  input wire [CONTROL_BITS-1:0] control,
  input wire [WIDTH*HEIGHT-1:0] tree,           // bits of F
  output wire [WIDTH*HEIGHT-1:0] enable,
  /* verilator lint_off UNUSEDSIGNAL */
  input wire [ADDRESS-1:0] shown_address,       // address to read at the next edge through the separate port
  input wire [SIDE-1:0] shown_row,
  /* verilator lint_on UNUSEDSIGNAL */
  // Valid in the clock after that edge; with a refresh word, one clock later.
  output reg [WIDTH-1:0] line
);
`include "control_word.vh"

  localparam PIXELS = WIDTH * HEIGHT;
  localparam CHIPS = (PIXELS + CHIP - 1) / CHIP;
  // Chosen so that a bank has at most one word to clear per clock.
  localparam CLEARED = (MEMORY_BITS + CLEAR_CLOCKS - 1) / CLEAR_CLOCKS;
  localparam BANKS = CLEARED > ALU_BITS ? CLEARED : ALU_BITS;

  // Select lines along columns and rows.
  wire [PIXELS-1:0] in_region;
  wire [SIDE-1:0] columns = control[CW_COLUMNS +: SIDE];
  wire [SIDE-1:0] rows = control[CW_ROWS +: SIDE];
  wire [WIDTH-1:0] in_columns;
  genvar x, y, c;
  generate
    for (x = 0; x < WIDTH; x = x + 1) begin : column
      localparam [31:0] COLUMN = x;
      assign in_columns[x] = COLUMN[SIDE-1:0] < columns | `FAULT(`FAULT_REGION);
    end
    for (y = 0; y < HEIGHT; y = y + 1) begin : row
      localparam [31:0] ROW = y;
      assign in_region[y*WIDTH +: WIDTH] = ROW[SIDE-1:0] < rows ? in_columns : {WIDTH{1'b0}};
    end
  endgenerate

  wire [PIXELS-1:0] shown;
  generate
    for (c = 0; c < CHIPS; c = c + 1) begin : chip
      localparam FIRST = c * CHIP;
      localparam HERE = FIRST + CHIP > PIXELS ? PIXELS - FIRST : CHIP;
      pixel_chip #(
        .PIXELS(HERE), .MEMORY_BITS(MEMORY_BITS), .MEMORY_READS(MEMORY_READS), .ALU_BITS(ALU_BITS), .ROOTS(ROOTS),
        .BANKS(BANKS), .OWN_PORT(OWN_PORT), .ADDRESS(ADDRESS), .SIDE(SIDE)
      ) pixels (
        .clk(clk), .reset(reset), .early(early), .control(control), .early_shown(shown_address),
        .in_region(in_region[FIRST +: HERE]), .tree(tree[FIRST +: HERE]), .enable(enable[FIRST +: HERE]),
        .shown(shown[FIRST +: HERE]));
    end
  endgenerate

  // Bits of the selected row, from the lines of all columns.
  wire [SIDE-1:0] chosen;
  reg [WIDTH-1:0] read;
  integer i;
  always @* begin
    read = {WIDTH{1'b0}};
    for (i = 0; i < HEIGHT; i = i + 1)
      if ({{(32-SIDE){1'b0}}, chosen} == i) read = read | shown[i*WIDTH +: WIDTH];
  end
  generate
    if (OWN_PORT != 0) begin : own_port
      reg [SIDE-1:0] row_here;
      always @(posedge clk) row_here <= shown_row;
      assign chosen = row_here;
      always @* line = read;
    end else begin : shared_port
      assign chosen = rows;
      always @(posedge clk) line <= read;
    end
  endgenerate
endmodule
