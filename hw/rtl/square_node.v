// The nodes of LANES multiplier trees of degree 2 (docs/machines/pixel-planes.md, "Trees") at one position. Both
// streams of each, the value and the slope, pass to the left child one clock later; the right child, h rows or columns
// further, receives
//
//   value + h * (slope + h * C)   and   slope + 2h * C
//
// for the coefficient C of the square. h times the slope is the slope DELAY = log2 h clocks later, from registers of
// the node; h * h * C and 2h * C arrive on wires shared by all nodes of a level.
`include "faults.vh"

module square_node #(
  parameter DELAY = 1,
  parameter LANES = 1
) (
  input wire clk,
  input wire reset,
  input wire first,         // first bit of the streams
  input wire counts,        // 1: the delayed slope belongs to this stream, not to the previous one
  input wire square,        // h * h * C
  input wire square_slope,  // 2h * C
  input wire [LANES-1:0] value,
  input wire [LANES-1:0] slope,
  output reg [LANES-1:0] left_value,
  output reg [LANES-1:0] left_slope,
  output reg [LANES-1:0] right_value,
  output reg [LANES-1:0] right_slope
);
  wire [LANES-1:0] late;
  delay #(.LENGTH(DELAY), .BITS(LANES)) times_h (.clk(clk), .reset(reset), .in(slope), .out(late));
  reg [LANES-1:0] step_carry;
  reg [LANES-1:0] value_carry;
  reg [LANES-1:0] slope_carry;
  wire [LANES-1:0] times = late & {LANES{counts | `FAULT(`FAULT_SLOPE_DELAY)}};
  wire [LANES-1:0] squared = {LANES{square}};
  wire [LANES-1:0] sloped = {LANES{square_slope}};
  wire [LANES-1:0] step_kept = step_carry & {LANES{~first}};
  wire [LANES-1:0] value_kept = value_carry & {LANES{~first}};
  wire [LANES-1:0] slope_kept = slope_carry & {LANES{~first}};
  wire [LANES-1:0] step = times ^ squared ^ step_kept;
  always @(posedge clk) begin
    if (reset) begin
      {left_value, left_slope, right_value, right_slope} <= {(4*LANES){1'b0}};
      {step_carry, value_carry, slope_carry} <= {(3*LANES){1'b0}};
    end else begin
      left_value <= value;
      left_slope <= slope;
      right_value <= value ^ step ^ value_kept;
      right_slope <= slope ^ sloped ^ slope_kept;
      step_carry <= (times & squared) | (times & step_kept) | (squared & step_kept);
      value_carry <= (value & step) | (value & value_kept) | (step & value_kept);
      slope_carry <= (slope & sloped) | (slope & slope_kept) | (sloped & slope_kept);
    end
  end
endmodule
