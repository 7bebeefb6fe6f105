// The multiplier trees of the Linear Expression Evaluator (thesis 7.2.1 and fig. 7.1; docs/machines/pixel-planes.md).
// They compute A*x + B*y + C at every pixel, one bit per clock, LEVELS_X + LEVELS_Y clocks after the bits of A, B and C
// have entered, least significant bit first, for streams that follow one another without gaps. An X tree delivers a sum
// to each column, and a Y tree per column delivers one to each pixel. If DEGREE is 2 they add XX*x*x + XY*x*y + YY*y*y.
// Pixel (x, y) is leaf y * WIDTH + x.
`include "faults.vh"

module linear_expression_evaluator #(
  parameter WIDTH = 8,
  parameter HEIGHT = 8,
  parameter LEVELS_X = 3,  // $clog2(WIDTH)
  parameter LEVELS_Y = 3,
  parameter DEGREE = 1     // 1 or 2
) (
  input wire clk,
  input wire reset,
  input wire first,        // the first bits of a stream are on the following wires
  input wire a,
  input wire b,
  input wire c,
  /* verilator lint_off UNUSEDSIGNAL */
  input wire xx,           // used with DEGREE 2
  input wire xy,
  input wire yy,
  /* verilator lint_on UNUSEDSIGNAL */
  output wire [WIDTH*HEIGHT-1:0] leaves
);
  // Additional outputs that square_tree.v needs.
  localparam MORE_X = DEGREE > 1 && LEVELS_X > 3 ? LEVELS_X - 3 : 0;
  localparam MORE_Y = DEGREE > 1 && LEVELS_Y > 3 ? LEVELS_Y - 3 : 0;

  wire [LEVELS_X+MORE_X:0] begins_x;
  wire [LEVELS_Y+MORE_Y:0] begins_y;
  wire [WIDTH-1:0] columns;

  tree_levels #(.LEVELS(LEVELS_X), .MORE(MORE_X)) x_levels (
    .clk(clk), .reset(reset), .first(first), .begins(begins_x));
  tree_levels #(.LEVELS(LEVELS_Y), .MORE(MORE_Y)) y_levels (
    .clk(clk), .reset(reset), .first(begins_x[LEVELS_X]), .begins(begins_y));

  generate
    if (DEGREE == 1) begin : linear
      // An unused wire has delay 0. B is needed from the clock in which C's sums leave the X tree.
      localparam DELAY_A = LEVELS_X > 0 ? LEVELS_X - 1 : 0;
      localparam DELAY_B = LEVELS_Y > 0 ? LEVELS_X + LEVELS_Y - 1 : 0;
      wire late_a;
      wire late_b;
      wire early_b;
      delay #(.LENGTH(DELAY_A), .BITS(1)) delay_a (.clk(clk), .reset(reset), .in(a), .out(late_a));
      delay #(.LENGTH(DELAY_B > 0 ? DELAY_B - 1 : 0), .BITS(1)) delay_early_b (
        .clk(clk), .reset(reset), .in(b), .out(early_b));
      delay #(.LENGTH(DELAY_B > 0 ? 1 : 0), .BITS(1)) delay_b (
        .clk(clk), .reset(reset), .in(early_b), .out(late_b));

      multiplier_tree #(.LEAVES(WIDTH), .LEVELS(LEVELS_X)) x_tree (
        .clk(clk), .reset(reset), .begins(begins_x), .multiplicand(late_a), .in(c), .out(columns));
      multiplier_tree #(.LEAVES(HEIGHT), .LEVELS(LEVELS_Y), .LANES(WIDTH)) y_trees (
        .clk(clk), .reset(reset), .begins(begins_y), .multiplicand(`FAULT(`FAULT_TREE_DELAY) ? early_b : late_b),
        .in(columns), .out(leaves));
    end else begin : quadratic
      // The slope along a column is B + XY*x, from a linear tree.
      localparam DELAY_XY = LEVELS_X > 0 ? LEVELS_X - 1 : 0;
      wire late_xy;
      wire late_yy;
      wire [WIDTH-1:0] slopes;
      delay #(.LENGTH(DELAY_XY), .BITS(1)) delay_xy (.clk(clk), .reset(reset), .in(xy), .out(late_xy));
      delay #(.LENGTH(LEVELS_X), .BITS(1)) delay_yy (.clk(clk), .reset(reset), .in(yy), .out(late_yy));

      square_tree #(.LEAVES(WIDTH), .LEVELS(LEVELS_X), .MORE(MORE_X)) x_tree (
        .clk(clk), .reset(reset), .begins(begins_x), .square(xx), .value(c), .slope(a), .out(columns));
      multiplier_tree #(.LEAVES(WIDTH), .LEVELS(LEVELS_X)) slope_tree (
        .clk(clk), .reset(reset), .begins(begins_x[LEVELS_X:0]), .multiplicand(late_xy), .in(b), .out(slopes));
      square_tree #(.LEAVES(HEIGHT), .LEVELS(LEVELS_Y), .MORE(MORE_Y), .LANES(WIDTH)) y_trees (
        .clk(clk), .reset(reset), .begins(begins_y), .square(`FAULT(`FAULT_TREE_DELAY) ? yy : late_yy), .value(columns),
        .slope(slopes), .out(leaves));
    end
  endgenerate
endmodule
