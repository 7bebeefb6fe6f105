// Checks sync signals of two pictures of 5 x 4 pixels in Icarus. Prints the errors, or "equal".
module video_timing_test;
  reg clk = 0;
  reg reset = 1;
  wire [15:0] x;
  wire [15:0] y;
  wire active, hsync, vsync;
  video_timing #(
    .WIDTH(5), .FRONT_X(1), .SYNC_X(2), .BACK_X(3), .HEIGHT(4), .FRONT_Y(1), .SYNC_Y(2), .BACK_Y(1)
  ) timing (.clk(clk), .reset(reset), .x(x), .y(y), .active(active), .hsync(hsync), .vsync(vsync));

  reg wrong = 0;
  integer t, column, line;
  initial begin
    #1 clk = 1;
    #1 clk = 0;
    reset = 0;
    for (t = 0; t < 2 * 11 * 8; t = t + 1) begin
      column = t % 11;
      line = t / 11 % 8;
      if (x != column || y != line) wrong = 1;
      if (active !== (column < 5 && line < 4)) wrong = 1;
      if (hsync !== (column != 6 && column != 7)) wrong = 1;
      if (vsync !== (line != 5 && line != 6)) wrong = 1;
      if (wrong) begin
        $display("video_timing_test: clock %0d: x %0d, y %0d, active %b, hsync %b, vsync %b", t, x, y, active, hsync, vsync);
        $finish(0);
      end
      #1 clk = 1;
      #1 clk = 0;
    end
    if (!wrong) $display("equal");
    $finish(0);
  end
endmodule
