// The OR of the enable bits of all pixels: levels of gates with FAN_IN inputs, each followed by a register, so that an
// answer takes one clock per level (docs/machines/pixel-planes.md, "Global OR"). If FAN_IN is 0, a single gate has all
// inputs and settles within the clock.
module global_or #(
  parameter LINES = 64,
  parameter FAN_IN = 64
) (
  /* verilator lint_off UNUSEDSIGNAL */
  input wire clk,
  input wire reset,
  /* verilator lint_on UNUSEDSIGNAL */
  input wire [LINES-1:0] lines,
  input wire asked,
  output wire valid,
  output wire any
);
  localparam GATES = FAN_IN == 0 ? 1 : (LINES + FAN_IN - 1) / FAN_IN;
  genvar i;
  generate
    if (FAN_IN == 0 || LINES == 1) begin : wire_or
      assign valid = asked;
      assign any = |lines;
    end else begin : level
      reg [GATES-1:0] gates;
      reg asked_here;
      always @(posedge clk) asked_here <= asked & ~reset;
      for (i = 0; i < GATES; i = i + 1) begin : gate
        localparam INPUTS = (i + 1) * FAN_IN > LINES ? LINES - i * FAN_IN : FAN_IN;
        always @(posedge clk) gates[i] <= |lines[i*FAN_IN +: INPUTS];
      end
      global_or #(.LINES(GATES), .FAN_IN(FAN_IN)) next (
        .clk(clk), .reset(reset), .lines(gates), .asked(asked_here), .valid(valid), .any(any));
    end
  endgenerate
endmodule
