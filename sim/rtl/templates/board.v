// The design on a board: power-on reset, LEDs, and the video on wires, with the leftmost pixel in the lowest ones. Each
// channel has its @CHANNEL_BITS@ highest bits.
module board (
  input wire clk,
@BOARD_PORTS@  output wire lamp_drawn,  // toggles with each drawn frame
  output wire lamp_shown,  // toggles with each shown frame
  output wire video_clk,
  output wire video_valid,
  output wire video_row,
  output wire video_frame,
  output wire [3*@CHANNEL_BITS@*@SCAN_PIXELS@-1:0] video
);
  reg [3:0] running = 4'd0;
  wire reset = running != 4'd15;
  reg drawn = 1'b0;
  reg seen = 1'b0;
  wire done, shown;
  wire [@VIDEO_WIRES@-1:0] colours;

  system machine (
    .clk(clk), .reset(reset), @BOARD_CONNECTIONS@.told(), .told_any(),
    .done(done), .clocks(), .video_valid(video_valid), .video_row(video_row), .video_frame(video_frame), .video(colours),
    .shown(shown));

  always @(posedge clk) begin
    if (reset) running <= running + 4'd1;
    drawn <= drawn ^ done;
    seen <= seen ^ shown;
  end
  assign lamp_drawn = drawn;
  assign lamp_shown = seen;
  assign video_clk = clk;
@BOARD_VIDEO@endmodule
