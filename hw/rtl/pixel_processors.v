// Pixels that obey the same control word and share their word lines: a bit-serial processor with enable, carry and latch,
// and its memory, at each; with CSGSIM_ROOTS a flag for roots too. Written from the meanings of the instruction table
// (hw/isa/opcodes.h), docs/machines/pixel-planes-4.md
// and thesis 7.2.1. Vectors have a bit a pixel; where they have several places of the ALU, the least significant first.
`include "faults.vh"

module pixel_processors #(
  parameter PIXELS = 64,
  parameter MEMORY_BITS = 72,
  parameter MEMORY_READS = 1,
  parameter ALU_BITS = 1,
  parameter ADDRESS = 7,
  parameter SIDE = 5
) (
  input wire clk,
  input wire reset,
  input wire [CONTROL_BITS-1:0] control,
  input wire [MEMORY_BITS-1:0] clear_line,
  input wire [PIXELS-1:0] in_region,
  input wire [PIXELS-1:0] tree,
  output wire [PIXELS-1:0] enable,
  output wire [PIXELS-1:0] carry,
  output wire [PIXELS-1:0] flag,
  output wire [PIXELS*ALU_BITS-1:0] latch,
  output wire [PIXELS*MEMORY_BITS-1:0] memory
);
`include "control_word.vh"

  wire [PIXELS*ALU_BITS-1:0] read_x;
  wire [PIXELS*ALU_BITS-1:0] read_y;
  wire [PIXELS*ALU_BITS-1:0] written;
  wire [PIXELS-1:0] may_write;
  wire [ALU_BITS-1:0] write = control[CW_ACTIVE +: ALU_BITS] & {ALU_BITS{control[CW_WRITE]}};

  pixel_processor #(
    .PIXELS(PIXELS), .MEMORY_READS(MEMORY_READS), .ALU_BITS(ALU_BITS), .ADDRESS(ADDRESS), .SIDE(SIDE)
  ) alus (
    .clk(clk), .reset(reset), .control(control), .in_region(in_region), .tree(tree),
    .memory_x(read_x), .memory_y(MEMORY_READS == 1 | `FAULT(`FAULT_SECOND_READ) ? read_x : read_y),
    .written(written), .may_write(may_write), .enable(enable), .carry(carry), .flag(flag),
    .latch(latch));

  pixel_memory #(.PIXELS(PIXELS), .MEMORY_BITS(MEMORY_BITS), .ALU_BITS(ALU_BITS), .ADDRESS(ADDRESS)) memories (
    .clk(clk), .reset(reset), .address_x(control[CW_X +: ADDRESS]), .address_y(control[CW_Y +: ADDRESS]),
    .address_w(control[CW_W +: ADDRESS]), .clear_line(clear_line), .written(written), .write(write),
    .may_write(may_write), .read_x(read_x), .read_y(read_y), .memory(memory));
endmodule
