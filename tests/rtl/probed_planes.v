// The machine of hw/rtl with its pixels' state on wires for comparison: pixel (x, y) has index y * WIDTH + x. With
// PROBES 0 these wires are 0, to measure the speed of simulation.
module probed_planes #(
  parameter WIDTH = 8,
  parameter HEIGHT = 8,
  parameter MEMORY_BITS = 40,
  parameter MEMORY_READS = 1,
  parameter ALU_BITS = 1,
  parameter DEGREE = 1,
  parameter LINK = 32,
  parameter FIFO_DEPTH = 16,
  parameter CLEAR_CLOCKS = 1,
  parameter HAS_OR = 1,
  parameter FAN_IN = 64,
  parameter SCAN_PIXELS = 1,
  parameter SCAN_SHARED = 0,
  parameter BUFFERS = 1,
  parameter COLOUR_BITS = 24,
  parameter CHIP = 64,
  parameter PROBES = 1,
  parameter VIDEO = SCAN_PIXELS > 0 ? SCAN_PIXELS * COLOUR_BITS : 1
) (
  input wire clk,
  input wire reset,
  input wire [7:0] fault,
  input wire frame,
  output wire request,
  output wire [31:0] request_from,
  input wire [LINK-1:0] word,
  input wire word_valid,
  output wire word_ready,
  output wire told,
  output wire told_any,
  output wire done,
  output wire [31:0] clocks,
  output wire video_valid,
  output wire video_row,
  output wire video_frame,
  output wire [VIDEO-1:0] video,
  output wire shown,

  output wire [WIDTH*HEIGHT-1:0] enable,
  output wire [WIDTH*HEIGHT-1:0] carry,
  output wire [WIDTH*HEIGHT-1:0] flag,
  output wire [WIDTH*HEIGHT-1:0] tree,
  output wire tree_valid,
  output wire [WIDTH*HEIGHT*ALU_BITS-1:0] latch,      // place 0 of every pixel first
  output wire [WIDTH*HEIGHT*MEMORY_BITS-1:0] memory,  // bit 0 of every pixel first
  output wire [10*32-1:0] counts                      // of counters.v, in the order of its ports
);
  pixel_planes #(
    .WIDTH(WIDTH), .HEIGHT(HEIGHT), .MEMORY_BITS(MEMORY_BITS), .MEMORY_READS(MEMORY_READS), .ALU_BITS(ALU_BITS),
    .DEGREE(DEGREE), .LINK(LINK), .FIFO_DEPTH(FIFO_DEPTH), .CLEAR_CLOCKS(CLEAR_CLOCKS), .HAS_OR(HAS_OR), .FAN_IN(FAN_IN),
    .SCAN_PIXELS(SCAN_PIXELS), .SCAN_SHARED(SCAN_SHARED), .BUFFERS(BUFFERS), .COLOUR_BITS(COLOUR_BITS), .CHIP(CHIP)
  ) machine (
    .clk(clk), .reset(reset), .fault(fault), .frame(frame), .request(request), .request_from(request_from), .word(word),
    .word_valid(word_valid), .word_ready(word_ready), .told(told), .told_any(told_any), .done(done), .clocks(clocks),
    .video_valid(video_valid), .video_row(video_row), .video_frame(video_frame), .video(video), .shown(shown));

  localparam ADDRESS = MEMORY_BITS > 1 ? $clog2(MEMORY_BITS) : 1;
  localparam SIDE = $clog2((WIDTH > HEIGHT ? WIDTH : HEIGHT) + 1);
`include "control_word.vh"
  localparam PIXELS = WIDTH * HEIGHT;
  localparam CHIPS = (PIXELS + CHIP - 1) / CHIP;
  localparam CLEARED = (MEMORY_BITS + CLEAR_CLOCKS - 1) / CLEAR_CLOCKS;
  localparam BANKS = CLEARED > ALU_BITS ? CLEARED : ALU_BITS;

  genvar c, a, i;
  generate
    if (PROBES == 0) begin : bare
      assign {tree, tree_valid, enable, carry, flag, latch, memory} = 0;
    end else begin : probed
      assign tree = machine.tree;
      assign tree_valid = machine.stream;
      assign enable = machine.enable;
    end
    for (c = 0; c < (PROBES == 0 ? 0 : CHIPS); c = c + 1) begin : chip
      localparam FIRST = c * CHIP;
      localparam HERE = FIRST + CHIP > PIXELS ? PIXELS - FIRST : CHIP;
      assign carry[FIRST +: HERE] = machine.processors.chip[c].pixels.processor.carry;
      assign flag[FIRST +: HERE] = machine.processors.chip[c].pixels.processor.flag;
      for (i = 0; i < ALU_BITS; i = i + 1) begin : place
        assign latch[i*PIXELS + FIRST +: HERE] = machine.processors.chip[c].pixels.processor.latch[i*HERE +: HERE];
      end
      for (a = 0; a < MEMORY_BITS; a = a + 1) begin : address
        assign memory[a*PIXELS + FIRST +: HERE] =
          machine.processors.chip[c].pixels.memory.bank[a % BANKS].cells.words[a / BANKS];
      end
    end
  endgenerate

  counters counted (
    .clk(clk), .reset(reset), .begins(request && request_from == 0), .spent(machine.spent),
    .refresh_waits(machine.refresh_waits), .issuing(counts[0 +: 32]), .clearing(counts[32 +: 32]),
    .starved(counts[64 +: 32]), .answering(counts[96 +: 32]), .jumping(counts[128 +: 32]),
    .refreshing(counts[160 +: 32]), .holding(counts[192 +: 32]), .copying(counts[224 +: 32]),
    .draining(counts[256 +: 32]), .waits(counts[288 +: 32]));
endmodule
