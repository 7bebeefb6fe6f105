// Draws the Program's frame several times, writes the scanned-out picture as PPM, and prints clocks. Plusargs:
//   +picture=FILE  file for the last picture
//   +frames=N      number of frames, default 2; measuring the frame interval needs two
//   +trace=FILE    clock of the first step of each instruction of the first frame
//   +wave=FILE     all wires as VCD
//   +from=N        from this clock of the first frame
//   +until=N       before this clock
// With PORTS_ALONE defined it uses only the ports of the design, which may then be a netlist; refresh words and the
// controller's clock account are not printed, and the trace is empty.
module testbench;
  localparam WIDTH = @WIDTH@;
  localparam HEIGHT = @HEIGHT@;
  localparam SCAN_PIXELS = @SCAN_PIXELS@;
  localparam VIDEO_BITS = @VIDEO_BITS@;  // bits of a pixel on the wires
  localparam RED = @RED_BITS@, GREEN = @GREEN_BITS@, BLUE = @BLUE_BITS@;  // bits of a colour, red the highest
  localparam [31:0] MOST_CLOCKS = 32'd2_000_000_000;

  reg clk;
  reg reset;
  wire request;
  wire [31:0] request_from;
  wire told, told_any, done;
  wire [31:0] clocks;
  wire video_valid, video_row, video_frame, shown;
  wire [SCAN_PIXELS*VIDEO_BITS-1:0] video;

  system dut (
    .clk(clk), .reset(reset), .request(request), .request_from(request_from), .told(told),
    .told_any(told_any), .done(done), .clocks(clocks), .video_valid(video_valid), .video_row(video_row),
    .video_frame(video_frame), .video(video), .shown(shown));

  wire begins_frame = request && request_from == 0;
`ifndef PORTS_ALONE
  // Refresh words that the controller sends for the scan-out, and the account of its clocks.
  wire refreshes = dut.machine.refresh & dut.machine.take_refresh;
  wire [31:0] issuing, clearing, starved, answering, jumping, refreshing, holding, copying, draining, waits;
  counters account (
    .clk(clk), .reset(reset), .begins(begins_frame), .spent(dut.machine.spent),
    .refresh_waits(dut.machine.refresh_waits), .issuing(issuing), .clearing(clearing), .starved(starved),
    .answering(answering), .jumping(jumping), .refreshing(refreshing), .holding(holding), .copying(copying),
    .draining(draining), .waits(waits));
  reg [31:0] refreshed;             // words since the previous picture was shown
  reg step_sent;                    // an instruction's first step is on the wires, in the controller's registers
`endif

  reg [8*256-1:0] name;
  reg [31:0] now;
  reg [31:0] frames, begun, drawn, finished;
  reg [31:0] began;                 // edge at which the current frame began
  reg [31:0] begans [0:3];          // the last four, by number modulo 4: at most three overlap
  reg [31:0] column, row;           // of the next pixel
  wire [31:0] column_here = video_row ? 0 : column;
  wire [31:0] row_here = video_frame ? 0 : video_row ? row + 1 : row;
  reg waving;
  reg recording;
  reg [31:0] from, until_clock;
  reg tracing;
  reg [23:0] picture [0:WIDTH*HEIGHT-1];
  integer file, trace, i;

  // Functions that are called at a clock edge: Verilator 5 takes their variables for registers.
  /* verilator lint_off BLKSEQ */
  // Scales a channel of `bits` bits to 0 to 255, rounded to nearest.
  function [7:0] level(input [23:0] channel, input integer bits);
    integer top;
    /* verilator lint_off UNUSEDSIGNAL */
    integer scaled;
    /* verilator lint_on UNUSEDSIGNAL */
    begin
      top = (1 << bits) - 1;
      scaled = top == 0 ? 0 : ({8'd0, channel} * 255 + top / 2) / top;
      level = scaled[7:0];
    end
  endfunction

  function [23:0] colour(input [VIDEO_BITS-1:0] packed_colour);
    reg [23:0] bits;
    begin
      bits = {{(24 - RED - GREEN - BLUE){1'b0}}, packed_colour[RED+GREEN+BLUE-1:0]};
      colour[23:16] = level(bits >> (GREEN + BLUE), RED);
      colour[15:8] = level((bits >> BLUE) & ((24'd1 << GREEN) - 24'd1), GREEN);
      colour[7:0] = level(bits & ((24'd1 << BLUE) - 24'd1), BLUE);
    end
  endfunction
  /* verilator lint_on BLKSEQ */

  task write_picture;
    begin
      if (!$value$plusargs("picture=%s", name)) name = "picture.ppm";
      file = $fopen(name, "wb");
      $fwrite(file, "P6\n%0d %0d\n255\n", WIDTH, HEIGHT);
      for (i = 0; i < WIDTH * HEIGHT; i = i + 1)
        $fwrite(file, "%c%c%c", picture[i][23:16], picture[i][15:8], picture[i][7:0]);
      $fclose(file);
    end
  endtask

  initial begin
    clk = 1'b0;
    reset = 1'b1;
    now = 0;
    begun = 0;
    drawn = 0;
    finished = 0;
    began = 0;
    column = 0;
    row = 0;
    if (!$value$plusargs("frames=%d", frames)) frames = 2;
    tracing = 1'b0;
    if ($value$plusargs("trace=%s", name)) begin
      trace = $fopen(name, "w");
      tracing = 1'b1;
    end
    if (!$value$plusargs("from=%d", from)) from = 0;
    if (!$value$plusargs("until=%d", until_clock)) until_clock = MOST_CLOCKS;
    waving = 1'b0;
    recording = 1'b1;
    if ($value$plusargs("wave=%s", name)) begin
      $dumpfile(name);
      $dumpvars(0, testbench);
      waving = 1'b1;
    end
    while (finished != frames && now != MOST_CLOCKS) begin
      #5 clk = 1'b1;
      #5 clk = 1'b0;
    end
    if (finished == frames) write_picture;
    else $display("testbench: no picture after %0d clocks", now);
    $finish(0);
  end

  always @(posedge recording) if (waving) $dumpon;
  always @(negedge recording) if (waving) $dumpoff;

  // Samples the values before the edge.
  always @(posedge clk) begin
    now <= now + 1;
    reset <= now < 2;
    if (begins_frame) begin
      if (begun != 0) $display("frame %0d: next after %0d clocks", begun - 1, now - began);
      began <= now;
      begans[begun[1:0]] <= now;
      begun <= begun + 1;
    end
    if (done) begin
      $display("frame %0d: drawn after %0d clocks", drawn, clocks);
`ifndef PORTS_ALONE
      $display("frame %0d: issuing %0d, clearing %0d, starved %0d, answering %0d, jumping %0d, draining %0d", drawn,
               issuing, clearing, starved, answering, jumping, draining);
      $display("frame %0d: refreshing %0d, refresh_waits %0d, holding %0d, copying %0d", drawn, refreshing, waits,
               holding, copying);
`endif
      drawn <= drawn + 1;
    end
    if (shown) begin
`ifdef PORTS_ALONE
      $display("frame %0d: shown after %0d clocks", finished, now - begans[finished[1:0]]);
`else
      $display("frame %0d: shown after %0d clocks, with %0d refresh words", finished, now - begans[finished[1:0]], refreshed);
`endif
      finished <= finished + 1;
    end
    // Clock now - began + 1 begins at this edge. Recording covers the clocks before the frame, to locate its beginning,
    // and one clock before the window, since recording starts in the middle of a clock.
    if (begun != 0) recording <= begun == 1 && now - began + 2 >= from && now - began + 1 < until_clock;
    if (told) $display("frame %0d: an enabled pixel: %b", begun - 1, told_any);
`ifndef PORTS_ALONE
    refreshed <= begun == 0 || shown ? 0 : refreshed + (refreshes ? 1 : 0);
    step_sent <= dut.machine.sequence_controller.begins_instruction && !reset;
    if (tracing && begun == 1 && step_sent) $fwrite(trace, "%0d\n", now - began);
`endif
    if (video_valid) begin
      for (i = 0; i < SCAN_PIXELS; i = i + 1)
        if (column_here + i < WIDTH) picture[row_here * WIDTH + column_here + i] <= colour(video[i*VIDEO_BITS +: VIDEO_BITS]);
      column <= column_here + SCAN_PIXELS;
      row <= row_here;
    end
  end
endmodule
