// The OR of all lines: gates of FAN_IN inputs (0: one that has all, within the clock) with a register behind each. What
// was asked arrives a clock a level later.
module global_or #(
  parameter LINES = 64,
  parameter FAN_IN = 64
) (
  input wire clk,
  input wire reset,
  input wire [LINES-1:0] lines,
  input wire asked,
  output wire valid,
  output wire any
);
  localparam GATES = FAN_IN == 0 ? 1 : (LINES + FAN_IN - 1) / FAN_IN;
  generate
    if (FAN_IN == 0 || LINES == 1) begin : wire_or
      assign valid = asked;
      assign any = |lines;
    end else begin : level
      reg [GATES-1:0] gates;
      reg asked_here;
      wire [GATES*FAN_IN-1:0] padded = lines;
      integer i;
      always @(posedge clk) begin
        asked_here <= asked & ~reset;
        for (i = 0; i < GATES; i = i + 1) gates[i] <= |padded[i*FAN_IN +: FAN_IN];
      end
      global_or #(.LINES(GATES), .FAN_IN(FAN_IN)) next (
        .clk(clk), .reset(reset), .lines(gates), .asked(asked_here), .valid(valid), .any(any));
    end
  endgenerate
endmodule
