// Sync signals for a monitor, counted in pixel clocks: WIDTH pixels of a line are active, followed by front porch, sync
// pulse and back porch; HEIGHT lines have the same structure. The scan-out has no pauses and shows each picture once,
// so a monitor needs a picture memory between the two, which is read at x and y. The defaults are those of 640 x 480 at
// 60 Hz with a pixel clock of 25.175 MHz.
module video_timing #(
  parameter WIDTH = 640,       // pixels
  parameter FRONT_X = 16,
  parameter SYNC_X = 96,
  parameter BACK_X = 48,
  parameter HEIGHT = 480,      // lines
  parameter FRONT_Y = 10,
  parameter SYNC_Y = 2,
  parameter BACK_Y = 33,
  parameter POSITIVE = 0       // 1: sync pulses are active high
) (
  input wire clk,
  input wire reset,
  output reg [15:0] x,         // position of the pixel in this clock
  output reg [15:0] y,
  output wire active,          // the pixel is visible; otherwise the output must be black
  output wire hsync,
  output wire vsync
);
  localparam [31:0] LINE = WIDTH + FRONT_X + SYNC_X + BACK_X;
  localparam [31:0] LINES = HEIGHT + FRONT_Y + SYNC_Y + BACK_Y;
  localparam [31:0] SEEN_X = WIDTH;
  localparam [31:0] SEEN_Y = HEIGHT;
  localparam [31:0] FROM_X = WIDTH + FRONT_X;
  localparam [31:0] TO_X = WIDTH + FRONT_X + SYNC_X;
  localparam [31:0] FROM_Y = HEIGHT + FRONT_Y;
  localparam [31:0] TO_Y = HEIGHT + FRONT_Y + SYNC_Y;
  localparam ONE = POSITIVE != 0;

  wire ends_line = x == LINE[15:0] - 16'd1;
  wire ends_picture = y == LINES[15:0] - 16'd1;
  assign active = x < SEEN_X[15:0] && y < SEEN_Y[15:0];
  assign hsync = (x >= FROM_X[15:0] && x < TO_X[15:0]) == ONE;
  assign vsync = (y >= FROM_Y[15:0] && y < TO_Y[15:0]) == ONE;

  always @(posedge clk) begin
    x <= reset || ends_line ? 16'd0 : x + 16'd1;
    if (reset) y <= 16'd0;
    else if (ends_line) y <= ends_picture ? 16'd0 : y + 16'd1;
  end
endmodule
