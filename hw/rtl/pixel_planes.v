// The whole machine: link, controller, multiplier trees, a pixel processor at every pixel, and the OR of their enable bits.
// Parts of docs/machines/pixel-planes-4.md that are not here: the scan-out with its refresh words, and a second buffer. Wires of the
// pixels for who looks on are at the end of the ports; pixel (x, y) is number y * WIDTH + x.
`include "faults.vh"

module pixel_planes #(
  parameter WIDTH = 8,
  parameter HEIGHT = 8,
  parameter MEMORY_BITS = 40,
  parameter MEMORY_READS = 1,
  parameter ALU_BITS = 1,
  parameter LINK = 32,
  parameter FIFO_DEPTH = 16,
  parameter CLEAR_CLOCKS = 1,
  parameter FAN_IN = 64
) (
  input wire clk,
  input wire reset,
`ifdef CSGSIM_PLANTED_FAULTS
  input wire [4:0] fault,
`endif

  // From the host, and to it.
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

  // To look at.
  output wire [WIDTH*HEIGHT-1:0] enable,
  output wire [WIDTH*HEIGHT-1:0] carry,
  output wire [WIDTH*HEIGHT-1:0] flag,
  output wire [WIDTH*HEIGHT-1:0] tree,
  output wire tree_valid,
  output wire [WIDTH*HEIGHT*ALU_BITS-1:0] latch,     // place 0 of every pixel first
  output wire [WIDTH*HEIGHT*MEMORY_BITS-1:0] memory  // bit 0 of every pixel first
);
  localparam ADDRESS = MEMORY_BITS > 1 ? $clog2(MEMORY_BITS) : 1;
  localparam SIDE = $clog2((WIDTH > HEIGHT ? WIDTH : HEIGHT) + 1);
  localparam LEVELS_X = $clog2(WIDTH);
  localparam LEVELS_Y = $clog2(HEIGHT);
  localparam LATENCY = LEVELS_X + LEVELS_Y;
  localparam PIXELS = WIDTH * HEIGHT;
`include "control_word.vh"

  wire [LINK-1:0] fifo_word;
  wire fifo_valid;
  wire take_word;
  wire drop_words;
  wire first, a, b, c;
  wire [CONTROL_BITS-1:0] control;
  wire [CONTROL_BITS-1:0] at_pixels;
  wire answer_valid;
  wire answer;

  fifo #(.DEPTH(FIFO_DEPTH), .BITS(LINK)) link (
    .clk(clk), .reset(reset), .drop(drop_words), .in(word), .in_valid(word_valid), .in_ready(word_ready),
    .out(fifo_word), .out_valid(fifo_valid), .take(take_word));

  controller #(
    .MEMORY_BITS(MEMORY_BITS), .MEMORY_READS(MEMORY_READS), .ALU_BITS(ALU_BITS), .LINK(LINK), .LATENCY(LATENCY),
    .CLEAR_CLOCKS(CLEAR_CLOCKS), .ADDRESS(ADDRESS), .SIDE(SIDE)
  ) sequence_controller (
    .clk(clk), .reset(reset), .frame(frame), .request(request), .request_from(request_from),
    .word(fifo_word), .word_valid(fifo_valid), .take_word(take_word), .drop_words(drop_words),
    .first(first), .a(a), .b(b), .c(c), .control(control), .answer_valid(answer_valid), .answer(answer),
    .told(told), .told_any(told_any), .done(done), .clocks(clocks));

  // A word meets the bits of F that entered the trees with it.
  delay #(.LENGTH(LATENCY), .BITS(CONTROL_BITS)) control_delay (
    .clk(clk), .reset(reset), .in(control), .out(at_pixels));

  linear_expression_evaluator #(.WIDTH(WIDTH), .HEIGHT(HEIGHT), .LEVELS_X(LEVELS_X), .LEVELS_Y(LEVELS_Y)) evaluator (
    .clk(clk), .reset(reset), .first(first), .a(a), .b(b), .c(c), .leaves(tree));
  assign tree_valid = at_pixels[CW_STREAM];

  // Lines along columns, rows and memory addresses, shared by the pixels.
  wire clear = at_pixels[CW_CLEAR];
  wire [SIDE-1:0] columns = at_pixels[CW_COLUMNS +: SIDE];
  wire [SIDE-1:0] rows = at_pixels[CW_ROWS +: SIDE];
  wire [ADDRESS:0] clear_count = at_pixels[CW_COUNT +: ADDRESS + 1];
  wire [ADDRESS-1:0] clear_from = at_pixels[CW_W +: ADDRESS];
  wire [MEMORY_BITS:0] cleared = ({{MEMORY_BITS{1'b0}}, 1'b1} << clear_count) - 1'b1;
  wire [MEMORY_BITS-1:0] clear_line = cleared[MEMORY_BITS-1:0] << clear_from & {MEMORY_BITS{clear}};

  wire [PIXELS-1:0] in_region;
  genvar x, y;
  generate
    for (y = 0; y < HEIGHT; y = y + 1) begin : row
      for (x = 0; x < WIDTH; x = x + 1) begin : column
        assign in_region[y*WIDTH + x] = (x < columns | `FAULT(`FAULT_REGION)) & y < rows;
      end
    end
  endgenerate

  pixel_processors #(
    .PIXELS(PIXELS), .MEMORY_BITS(MEMORY_BITS), .MEMORY_READS(MEMORY_READS), .ALU_BITS(ALU_BITS), .ADDRESS(ADDRESS),
    .SIDE(SIDE)
  ) processors (
    .clk(clk), .reset(reset), .control(at_pixels), .clear_line(clear_line), .in_region(in_region),
    .tree(tree), .enable(enable), .carry(carry), .flag(flag), .latch(latch), .memory(memory));

  wire [PIXELS-1:0] counted = `FAULT(`FAULT_QUESTION) ? enable & ~({PIXELS{1'b1}} << PIXELS / 2) : enable;
  global_or #(.LINES(PIXELS), .FAN_IN(FAN_IN)) enabled (
    .clk(clk), .reset(reset), .lines(counted), .asked(at_pixels[CW_QUESTION]), .valid(answer_valid), .any(answer));
endmodule
