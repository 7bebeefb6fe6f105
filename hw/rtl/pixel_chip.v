// A chip of PIXELS pixels (thesis 7.2.1: 64 to 128) that execute the same control word: each has a bit-serial processor
// with its registers, and memory whose word lines they share. Vectors have one bit per pixel; if they have several
// places of the ALU, the least significant place comes first.
module pixel_chip #(
  parameter PIXELS = 64,
  parameter MEMORY_BITS = 72,
  parameter MEMORY_READS = 1,
  parameter ALU_BITS = 1,
  parameter ROOTS = 1,
  parameter BANKS = 1,
  parameter OWN_PORT = 0,
  parameter ADDRESS = 7,
  parameter SIDE = 5
) (
  input wire clk,
  input wire reset,
  /* verilator lint_off UNUSEDSIGNAL */
  input wire [CONTROL_BITS-1:0] early,          // control word of the next clock
  /* verilator lint_on UNUSEDSIGNAL */
  input wire [CONTROL_BITS-1:0] control,
  input wire [ADDRESS-1:0] early_shown,         // address for the scan-out's separate port in the next clock
  input wire [PIXELS-1:0] in_region,            // pixels of the region in a clearing word
  input wire [PIXELS-1:0] tree,                 // bits of F
  output wire [PIXELS-1:0] enable,
  output wire [PIXELS-1:0] shown                // bits read by the scan-out
);
`include "control_word.vh"

  wire [PIXELS*ALU_BITS-1:0] read_x;
  wire [PIXELS*ALU_BITS-1:0] read_y;
  wire [PIXELS*ALU_BITS-1:0] written;
  wire [PIXELS-1:0] may_write;
  wire [ALU_BITS-1:0] write = control[CW_ACTIVE +: ALU_BITS] & {ALU_BITS{control[CW_WRITE]}};

  pixel_processor #(
    .PIXELS(PIXELS), .MEMORY_READS(MEMORY_READS), .ALU_BITS(ALU_BITS), .ROOTS(ROOTS), .ADDRESS(ADDRESS), .SIDE(SIDE)
  ) processor (
    .clk(clk), .reset(reset), .control(control), .in_region(in_region), .tree(tree), .memory_x(read_x), .memory_y(read_y),
    .written(written), .may_write(may_write), .enable(enable));

  pixel_memory #(
    .PIXELS(PIXELS), .MEMORY_BITS(MEMORY_BITS), .MEMORY_READS(MEMORY_READS), .ALU_BITS(ALU_BITS), .BANKS(BANKS),
    .OWN_PORT(OWN_PORT), .ADDRESS(ADDRESS)
  ) memory (
    .clk(clk), .early_x(early[CW_X +: ADDRESS]), .early_y(early[CW_Y +: ADDRESS]), .early_shown(early_shown),
    .early_w(early[CW_W +: ADDRESS]), .early_count(early[CW_COUNT +: ADDRESS + 1]), .clear(control[CW_CLEAR]),
    .write(write), .may_write(may_write), .written(written), .read_x(read_x), .read_y(read_y), .read_shown(shown));
endmodule
