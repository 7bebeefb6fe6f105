// The serial multiplier trees of the Linear Expression Evaluator (thesis 7.2.1 and fig. 7.1). Written from
// docs/machines/pixel-planes-4.md: a node passes its input on, a clock later, to one child, and to the other the sum of its input
// and the multiplicand's bit, from a one-bit adder that keeps its carry.
//
// Streams come least significant bit first and back to back. Level k of n (the root is level 0) gets a stream k clocks
// after the root. The multiplicand enters n - 1 clocks after the stream, on a wire that all levels share, so that at level k
// it is worth 2^(n - 1 - k) times itself.
`include "faults.vh"

// A*x + B*y + C at every pixel, a bit a clock, LEVELS_X + LEVELS_Y clocks after its bits of A, B and C. Pixel (x, y) is
// bit y * WIDTH + x.
module linear_expression_evaluator #(
  parameter WIDTH = 8,
  parameter HEIGHT = 8,
  parameter LEVELS_X = 3,
  parameter LEVELS_Y = 3
) (
  input wire clk,
  input wire reset,
  input wire first,
  input wire a,
  input wire b,
  input wire c,
  output wire [WIDTH*HEIGHT-1:0] leaves
);
  // A wire that no level looks at has no length; B is needed when C's sums come out of the X tree, and later.
  localparam DELAY_A = LEVELS_X > 0 ? LEVELS_X - 1 : 0;
  localparam DELAY_B = LEVELS_Y > 0 ? LEVELS_X + LEVELS_Y - 1 : 0;

  wire [LEVELS_X:0] begins_x;
  wire [LEVELS_X:0] counts_x;
  wire [LEVELS_Y:0] begins_y;
  wire [LEVELS_Y:0] counts_y;
  wire late_a;
  wire late_b;
  wire early_b;
  wire [WIDTH-1:0] columns;

  delay #(.LENGTH(DELAY_A)) delay_a (.clk(clk), .reset(reset), .in(a), .out(late_a));
  delay #(.LENGTH(DELAY_B > 0 ? DELAY_B - 1 : 0)) delay_early_b (.clk(clk), .reset(reset), .in(b), .out(early_b));
  delay #(.LENGTH(DELAY_B > 0 ? 1 : 0)) delay_b (.clk(clk), .reset(reset), .in(early_b), .out(late_b));

  tree_levels #(.LEVELS(LEVELS_X)) x_levels (
    .clk(clk), .reset(reset), .first(first), .begins(begins_x), .counts(counts_x));
  tree_levels #(.LEVELS(LEVELS_Y)) y_levels (
    .clk(clk), .reset(reset), .first(begins_x[LEVELS_X]), .begins(begins_y), .counts(counts_y));

  multiplier_tree #(.LEAVES(WIDTH), .LEVELS(LEVELS_X)) x_tree (
    .clk(clk), .reset(reset), .begins(begins_x), .counts(counts_x), .multiplicand(late_a), .in(c),
    .out(columns));

  genvar x, y;
  generate
    for (x = 0; x < WIDTH; x = x + 1) begin : column
      wire [HEIGHT-1:0] rows;
      multiplier_tree #(.LEAVES(HEIGHT), .LEVELS(LEVELS_Y)) y_tree (
        .clk(clk), .reset(reset), .begins(begins_y), .counts(counts_y),
        .multiplicand(`FAULT(`FAULT_TREE_DELAY) ? early_b : late_b), .in(columns[x]), .out(rows));
      for (y = 0; y < HEIGHT; y = y + 1) begin : row
        assign leaves[y*WIDTH + x] = rows[y];
      end
    end
  endgenerate
endmodule
