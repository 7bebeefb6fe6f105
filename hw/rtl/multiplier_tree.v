`include "faults.vh"

// Adds multiplicand * i to the stream for each leaf i. Node 1 is the root, those below node n are 2n and 2n + 1, and leaf i
// is number LEAVES_ROUNDED + i. Nodes that have no leaf are left out.
module multiplier_tree #(
  parameter LEAVES = 8,
  parameter LEVELS = 3
) (
  input wire clk,
  input wire reset,
  input wire [LEVELS:0] begins,
  input wire [LEVELS:0] counts,
  input wire multiplicand,
  input wire in,
  output wire [LEAVES-1:0] out
);
  localparam ROUNDED = 1 << LEVELS;
  wire [2*ROUNDED-1:0] stream;
  assign stream[0] = 1'b0;
  assign stream[1] = in;
  assign out = stream[ROUNDED +: LEAVES];

  genvar k, i;
  generate
    for (k = 0; k < LEVELS; k = k + 1) begin : level
      for (i = 0; i < (1 << k); i = i + 1) begin : at
        if (i << (LEVELS - k) < LEAVES) begin : there
          tree_node node (
            .clk(clk), .reset(reset), .first(begins[k]), .multiplicand(multiplicand & counts[k]),
            .in(stream[(1 << k) + i]), .left(stream[2 * ((1 << k) + i)]), .right(stream[2 * ((1 << k) + i) + 1]));
        end else begin : missing
          assign stream[2 * ((1 << k) + i) +: 2] = 2'b00;
        end
      end
    end
  endgenerate
endmodule
