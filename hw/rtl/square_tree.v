// LANES multiplier trees of degree 2 (docs/machines/pixel-planes.md, "Trees"): from its value and slope, each tree
// computes for each leaf i the number value + slope * i + C * i * i, LEVELS clocks later. Nodes are numbered as in
// multiplier_tree.v.
//
// The coefficient C of the square arrives with the streams and passes through registers shared by all nodes of a level.
// The wire at level k, with h = 2^s and s = LEVELS - 1 - k, carries h * h * C if delayed by k + 2s clocks, and 2h * C
// if delayed by k + s + 1. It is used from bit 2s of the streams on, or from bit s + 1. Until then it carries the end
// of the previous streams.
`include "faults.vh"

module square_tree #(
  parameter LEAVES = 8,
  parameter LEVELS = 3,  // $clog2(LEAVES)
  parameter MORE = 0,    // LEVELS - 3, or 0 if negative
  parameter LANES = 1
) (
  input wire clk,
  input wire reset,
  input wire [LEVELS+MORE:0] begins,  // start of the streams at each level and in later clocks (tree_levels.v)
  input wire square,                  // bit of C
  input wire [LANES-1:0] value,
  input wire [LANES-1:0] slope,
  output wire [LEAVES*LANES-1:0] out  // lanes of leaf 0 first, then of leaf 1, and so on
);
  localparam ROUNDED = 1 << LEVELS;
  localparam WIRE = LEVELS > 1 ? 2 * LEVELS - 2 : LEVELS;  // longest delay of C

  wire [WIRE:0] squares;  // C, delayed by as many clocks as the index
  assign squares[0] = square;
  genvar j, k, i;
  generate
    for (j = 0; j < WIRE; j = j + 1) begin : tap
      delay #(.LENGTH(1), .BITS(1)) one (.clk(clk), .reset(reset), .in(squares[j]), .out(squares[j + 1]));
    end
  endgenerate

  /* verilator lint_off UNUSEDSIGNAL */
  wire [2*ROUNDED*LANES-1:0] values;
  wire [2*ROUNDED*LANES-1:0] slopes;
  wire unused = clk | reset | |begins | |squares;
  /* verilator lint_on UNUSEDSIGNAL */
  assign values[0 +: 2*LANES] = {value, {LANES{1'b0}}};
  assign slopes[0 +: 2*LANES] = {slope, {LANES{1'b0}}};
  assign out = values[ROUNDED*LANES +: LEAVES*LANES];

  generate
    for (k = 0; k < LEVELS; k = k + 1) begin : level
      localparam S = LEVELS - 1 - k;
      wire counts;         // 1: the slope's bit is used, from bit S on
      wire counts_square;  // 1: h * h * C is used, from bit 2S on
      wire counts_slope = ~|begins[k+S:k];
      if (S > 0) begin : late
        assign counts = ~|begins[k+S-1:k];
        assign counts_square = ~|begins[k+2*S-1:k] | `FAULT(`FAULT_SQUARE_SELECT);
      end else begin : at_once
        assign counts = 1'b1;
        assign counts_square = 1'b1;
      end
      for (i = 0; i < (1 << k); i = i + 1) begin : at
        localparam NODE = (1 << k) + i;
        if (i << (LEVELS - k) < LEAVES) begin : there
          localparam LEFT = 2 * NODE * LANES;
          localparam RIGHT = LEFT + LANES;
          square_node #(.DELAY(S), .LANES(LANES)) node (
            .clk(clk), .reset(reset), .first(begins[k]), .counts(counts), .square(squares[k+2*S] & counts_square),
            .square_slope(squares[k+S+1] & counts_slope), .value(values[NODE*LANES +: LANES]),
            .slope(slopes[NODE*LANES +: LANES]), .left_value(values[LEFT +: LANES]), .left_slope(slopes[LEFT +: LANES]),
            .right_value(values[RIGHT +: LANES]), .right_slope(slopes[RIGHT +: LANES]));
        end else begin : missing
          assign values[2*NODE*LANES +: 2*LANES] = {(2*LANES){1'b0}};
          assign slopes[2*NODE*LANES +: 2*LANES] = {(2*LANES){1'b0}};
        end
      end
    end
  endgenerate
endmodule
