// Counts the clocks of a frame by use, as the stats of csgsim do (docs/machines/pixel-planes.md). It is for a
// testbench, which connects it to the controller's wires. The counts refer to the current frame or, between frames, to
// the last one; their sum is the number of its clocks.
module counters (
  input wire clk,
  input wire reset,
  input wire begins,                // start of a frame: the controller requests instruction 0
  input wire [3:0] spent,           // from the controller
  input wire refresh_waits,         // from the controller
  output reg [31:0] issuing,
  output reg [31:0] clearing,
  output reg [31:0] starved,        // waiting for a command, except after a jump
  output reg [31:0] answering,      // waiting for the answer of the global OR
  output reg [31:0] jumping,        // waiting for the first command after a jump
  output reg [31:0] refreshing,     // refresh words sent while the controller had nothing else to do
  output reg [31:0] holding,        // waiting to copy until the previous picture is latched
  output reg [31:0] copying,
  output reg [31:0] draining,
  output reg [31:0] waits           // clocks in which a requested refresh word had to wait
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
