// The whole machine (docs/machines/pixel-planes.md): link, controller, delay of the control word, multiplier trees, a
// pixel processor with memory at every pixel, the OR of the enable bits, and the scan-out. Pixel (x, y) is number y *
// WIDTH + x. The machine has a single clock; every output except word_ready is registered.
//
// The host has words of LINK bits for a frame, and holds `frame` at 1 until the machine requests the words from
// instruction 0 on. A request issued in a clock reaches the host at the edge that ends this clock. A word is
// transferred at an edge at which it is valid and the machine is ready.
`include "faults.vh"

module pixel_planes #(
  parameter WIDTH = 8,          // pixels: at least two in total
  parameter HEIGHT = 8,
  parameter MEMORY_BITS = 40,   // per pixel
  parameter MEMORY_READS = 1,   // reads per clock, 1 or 2
  parameter ALU_BITS = 1,       // places of the ALU
  parameter DEGREE = 1,         // degree of expressions, 1 or 2
  parameter ROOTS = 1,          // 0: Programs contain no `root`
  parameter LINK = 32,          // bits of a link word
  parameter FIFO_DEPTH = 16,    // words of the FIFO
  parameter CLEAR_CLOCKS = 1,   // clocks to clear memory
  parameter HAS_OR = 1,         // 0: Programs contain no questions
  parameter FAN_IN = 64,        // inputs of a gate of the global OR; 0: a single gate
  parameter SCAN_PIXELS = 1,    // pixels shown per clock; 0: none
  parameter SCAN_SHARED = 0,    // 1: colours are read through the pixels' port
  parameter BUFFERS = 1,        // pictures in memory, 1 or 2
  parameter COLOUR_BITS = 24,   // maximum bits of a shown pixel
  parameter CHIP = 64,          // pixels that share word lines and their decoders
  // Number of wires of `video`; 1 if nothing is shown.
  parameter VIDEO = SCAN_PIXELS > 0 ? SCAN_PIXELS * COLOUR_BITS : 1
) (
  input wire clk,
  input wire reset,
`ifdef CSGSIM_PLANTED_FAULTS
  input wire [7:0] fault,
`endif

  input wire frame,                 // the host has a frame
  output wire request,              // requests the words from instruction request_from on
  output wire [31:0] request_from,
  input wire [LINK-1:0] word,
  input wire word_valid,
  output wire word_ready,
  output wire told,                 // reports the answer to a global_or
  output wire told_any,             // that answer: whether any pixel is enabled
  output wire done,                 // 1: the frame is drawn; with two buffers, also copied
  output wire [31:0] clocks,        // clocks of the frame

  output wire video_valid,          // pixels are shown in this clock
  output wire video_row,            // 1: these pixels are the first of a row
  output wire video_frame,          // 1: these pixels are the first of a picture
  output wire [VIDEO-1:0] video,    // pixels from the left, COLOUR_BITS each; 0 beyond the end of a row
  output wire shown                 // a picture has been shown completely
);
  localparam ADDRESS = MEMORY_BITS > 1 ? $clog2(MEMORY_BITS) : 1;
  localparam SIDE = $clog2((WIDTH > HEIGHT ? WIDTH : HEIGHT) + 1);
  localparam LEVELS_X = $clog2(WIDTH);
  localparam LEVELS_Y = $clog2(HEIGHT);
  localparam LATENCY = LEVELS_X + LEVELS_Y;
  localparam SHOWS = SCAN_PIXELS > 0 ? 1 : 0;
`include "control_word.vh"

  wire [LINK-1:0] fifo_word;
  wire fifo_valid, take_word, drop_words;
  wire first, a, b, c, xx, xy, yy;
  wire [CONTROL_BITS-1:0] control;
  wire [CONTROL_BITS-1:0] early;
  wire [CONTROL_BITS-1:0] at_pixels;
  wire [WIDTH*HEIGHT-1:0] tree;
  wire [WIDTH*HEIGHT-1:0] enable;
  wire answer_valid, answer;
  wire picture, take_picture;
  wire [11:0] picture_base;
  wire [5:0] picture_width;
  wire refresh, take_refresh, latched;
  wire [ADDRESS-1:0] refresh_address;
  wire [SIDE-1:0] refresh_row;
  wire [ADDRESS-1:0] shown_address;
  wire [SIDE-1:0] shown_row;
  wire [WIDTH-1:0] line;
  /* verilator lint_off UNUSEDSIGNAL */
  wire [3:0] spent;     // for counters.v
  wire refresh_waits;
  // Signals for waves.
  wire stream = at_pixels[CW_STREAM];  // `tree` carries bits of F
  wire [ALU_BITS-1:0] active = at_pixels[CW_ACTIVE +: ALU_BITS];
  /* verilator lint_on UNUSEDSIGNAL */

  fifo #(.DEPTH(FIFO_DEPTH), .BITS(LINK)) link (
    .clk(clk), .reset(reset), .drop(drop_words), .in(word), .in_valid(word_valid), .in_ready(word_ready),
    .out(fifo_word), .out_valid(fifo_valid), .take(take_word));

  controller #(
    .MEMORY_BITS(MEMORY_BITS), .MEMORY_READS(MEMORY_READS), .ALU_BITS(ALU_BITS), .DEGREE(DEGREE), .LINK(LINK),
    .LATENCY(LATENCY), .CLEAR_CLOCKS(CLEAR_CLOCKS), .SHOWS(SHOWS), .BUFFERS(BUFFERS), .ADDRESS(ADDRESS), .SIDE(SIDE)
  ) sequence_controller (
    .clk(clk), .reset(reset), .frame(frame), .request(request), .request_from(request_from), .word(fifo_word),
    .word_valid(fifo_valid), .take_word(take_word), .drop_words(drop_words), .refresh(refresh),
    .refresh_address(refresh_address), .refresh_row(refresh_row), .take_refresh(take_refresh), .latched(latched),
    .picture(picture), .picture_base(picture_base), .picture_width(picture_width), .take_picture(take_picture),
    .first(first), .a(a), .b(b), .c(c), .xx(xx), .xy(xy), .yy(yy), .control(control), .answer_valid(answer_valid),
    .answer(answer), .told(told), .told_any(told_any), .done(done), .clocks(clocks), .spent(spent),
    .refresh_waits(refresh_waits));

  control_delay #(.LATENCY(LATENCY), .BITS(CONTROL_BITS)) way (
    .clk(clk), .reset(reset), .in(control), .early(early), .out(at_pixels));

  linear_expression_evaluator #(
    .WIDTH(WIDTH), .HEIGHT(HEIGHT), .LEVELS_X(LEVELS_X), .LEVELS_Y(LEVELS_Y), .DEGREE(DEGREE)
  ) evaluator (
    .clk(clk), .reset(reset), .first(first), .a(a), .b(b), .c(c), .xx(xx), .xy(xy), .yy(yy), .leaves(tree));

  pixel_processors #(
    .WIDTH(WIDTH), .HEIGHT(HEIGHT), .CHIP(CHIP), .MEMORY_BITS(MEMORY_BITS), .MEMORY_READS(MEMORY_READS),
    .ALU_BITS(ALU_BITS), .ROOTS(ROOTS), .CLEAR_CLOCKS(CLEAR_CLOCKS), .OWN_PORT(SHOWS != 0 && SCAN_SHARED == 0 ? 1 : 0),
    .ADDRESS(ADDRESS), .SIDE(SIDE)
  ) processors (
    .clk(clk), .reset(reset), .early(early), .control(at_pixels), .tree(tree), .enable(enable),
    .shown_address(shown_address), .shown_row(shown_row), .line(line));

  generate
    if (HAS_OR != 0) begin : asks
      wire [WIDTH*HEIGHT-1:0] none = 0;
      wire [WIDTH*HEIGHT-1:0] half = ~none >> ((WIDTH * HEIGHT + 1) / 2);
      wire [WIDTH*HEIGHT-1:0] counted = `FAULT(`FAULT_QUESTION) ? enable & half : enable;
      global_or #(.LINES(WIDTH * HEIGHT), .FAN_IN(FAN_IN)) enabled (
        .clk(clk), .reset(reset), .lines(counted), .asked(at_pixels[CW_QUESTION]), .valid(answer_valid), .any(answer));
    end else begin : asks_nothing
      assign answer_valid = 1'b0;
      assign answer = 1'b0;
      /* verilator lint_off UNUSEDSIGNAL */
      wire unused = |enable;
      /* verilator lint_on UNUSEDSIGNAL */
    end

    if (SHOWS != 0) begin : shows
      scan_out #(
        .WIDTH(WIDTH), .HEIGHT(HEIGHT), .PIXELS(SCAN_PIXELS), .COLOUR_BITS(COLOUR_BITS), .SHARED(SCAN_SHARED),
        .ADDRESS(ADDRESS), .SIDE(SIDE)
      ) screen (
        .clk(clk), .reset(reset), .picture(picture), .picture_base(picture_base), .picture_width(picture_width),
        .take_picture(take_picture), .refresh(refresh), .refresh_address(refresh_address), .refresh_row(refresh_row),
        .take_refresh(take_refresh), .refreshes(at_pixels[CW_REFRESH]), .shown_address(shown_address),
        .shown_row(shown_row), .line(line), .latched(latched), .video_valid(video_valid), .video_row(video_row),
        .video_frame(video_frame), .video(video), .shown(shown));
    end else begin : shows_nothing
      assign {take_picture, refresh, latched, video_valid, video_row, video_frame, shown} = 7'b0000000;
      assign refresh_address = 0;
      assign refresh_row = 0;
      assign shown_address = 0;
      assign shown_row = 0;
      assign video = 0;
      /* verilator lint_off UNUSEDSIGNAL */
      wire unused = picture | |picture_base | |picture_width | take_refresh | |line;
      /* verilator lint_on UNUSEDSIGNAL */
    end
  endgenerate
endmodule
