// A node of a multiplier tree of degree 2 (docs/machines/pixel-powers.md, "Trees"): its streams, the value and the slope, are
// passed on to the left child a clock later; the right child, h rows or columns on, gets
//   value + h * (slope + h * C)   and   slope + 2h * C
// for the coefficient C of the square. h times the slope is the slope DELAY = log2 h clocks later, from registers of the
// node's own; h * h * C and 2h * C come on wires that all nodes of a level share.
`include "faults.vh"

module square_node #(
  parameter DELAY = 1
) (
  input wire clk,
  input wire reset,
  input wire first,         // bit of the streams
  input wire counts,        // the delayed slope is of this stream, not of the one before
  input wire square,        // h * h * C
  input wire square_slope,  // 2h * C
  input wire value,
  input wire slope,
  output reg left_value,
  output reg left_slope,
  output reg right_value,
  output reg right_slope
);
  wire late;
  delay #(.LENGTH(DELAY), .BITS(1)) times_h (.clk(clk), .reset(reset), .in(slope), .out(late));
  reg step_carry, value_carry, slope_carry;
  wire times = late & (counts | `FAULT(`FAULT_SLOPE_DELAY));
  wire step_kept = step_carry & ~first;
  wire value_kept = value_carry & ~first;
  wire slope_kept = slope_carry & ~first;
  wire step = times ^ square ^ step_kept;
  always @(posedge clk) begin
    if (reset) begin
      {left_value, left_slope, right_value, right_slope} <= 4'b0000;
      {step_carry, value_carry, slope_carry} <= 3'b000;
    end else begin
      left_value <= value;
      left_slope <= slope;
      right_value <= value ^ step ^ value_kept;
      right_slope <= slope ^ square_slope ^ slope_kept;
      step_carry <= (times & square) | (times & step_kept) | (square & step_kept);
      value_carry <= (value & step) | (value & value_kept) | (step & value_kept);
      slope_carry <= (slope & square_slope) | (slope & slope_kept) | (square_slope & slope_kept);
    end
  end
endmodule
