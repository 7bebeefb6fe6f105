// LANES multiplier trees of degree 2 (docs/machines/pixel-planes.md, "Trees"): of its value and slope each makes
// value + slope * i + C * i * i for each leaf i, LEVELS clocks later. Nodes are numbered as in multiplier_tree.v.
//
// The coefficient C of the square comes with the streams, and goes through registers that all nodes of a level share. At
// level k, with h = 2^s and s = LEVELS - 1 - k, it is h * h * C if it has been delayed by k + 2s clocks, and 2h * C by
// k + s + 1; it counts from bit 2s of the streams on, or s + 1. Until then its wire has the end of the streams before.
`include "faults.vh"

module square_tree #(
  parameter LEAVES = 8,
  parameter LEVELS = 3,  // $clog2(LEAVES)
  parameter MORE = 0,    // LEVELS - 3, or 0 if that is less
  parameter LANES = 1
) (
  input wire clk,
  input wire reset,
  input wire [LEVELS+MORE:0] begins,  // streams, at each level and so many clocks later (tree_levels.v)
  input wire square,                  // bit of C
  input wire [LANES-1:0] value,
  input wire [LANES-1:0] slope,
  output wire [LEAVES*LANES-1:0] out  // the lanes of leaf 0 first
);
  localparam ROUNDED = 1 << LEVELS;
  localparam WIRE = LEVELS > 1 ? 2 * LEVELS - 2 : LEVELS;  // the longest delay of C

  wire [WIRE:0] squares;  // C, so many clocks later
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
      wire counts;         // the slope's bit, from bit S on
      wire counts_square;  // h * h * C, from bit 2S on
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
