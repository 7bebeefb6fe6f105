// Where the clocks of a frame go, counted as the stats of csgsim do (docs/machines/pixel-planes.md): for a testbench,
// beside the machine, on the controller's wires. The counts are of the frame that is being drawn, or was drawn last;
// they add up to its clocks.
module counters (
  input wire clk,
  input wire reset,
  input wire begins,                // the controller asks for a frame: its request, from instruction 0 on
  input wire [3:0] spent,           // of the controller
  input wire refresh_waits,         // likewise
  output reg [31:0] issuing,
  output reg [31:0] clearing,
  output reg [31:0] starved,        // idle, as no command has come
  output reg [31:0] answering,
  output reg [31:0] jumping,
  output reg [31:0] refreshing,     // words, where nothing else was to be done
  output reg [31:0] holding,
  output reg [31:0] copying,
  output reg [31:0] draining,
  output reg [31:0] waits           // clocks in which a refresh word was asked for and had to wait
);
`include "spent.vh"

  wire restart = reset | begins;
  always @(posedge clk) begin
    if (restart) begin
      {issuing, clearing, starved, answering, jumping} <= 160'd0;
      {refreshing, holding, copying, draining, waits} <= 160'd0;
    end
    case (spent)
      SPENT_ISSUING: issuing <= (restart ? 0 : issuing) + 1;
      SPENT_CLEARING: clearing <= (restart ? 0 : clearing) + 1;
      SPENT_STARVED: starved <= (restart ? 0 : starved) + 1;
      SPENT_ANSWERING: answering <= (restart ? 0 : answering) + 1;
      SPENT_JUMPING: jumping <= (restart ? 0 : jumping) + 1;
      SPENT_REFRESHING: refreshing <= (restart ? 0 : refreshing) + 1;
      SPENT_HOLDING: holding <= (restart ? 0 : holding) + 1;
      SPENT_COPYING: copying <= (restart ? 0 : copying) + 1;
      SPENT_DRAINING: draining <= (restart ? 0 : draining) + 1;
      default: ;
    endcase
    if (refresh_waits) waits <= (restart ? 0 : waits) + 1;
  end
endmodule
