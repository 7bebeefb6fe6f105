// LANES serial multiplier trees (thesis 7.2.1 and fig. 7.1): for each leaf i, each tree adds multiplicand * i to its
// stream, LEVELS clocks later. Node 1 is the root, the children of node n are 2n and 2n + 1, and leaf i is node
// 2^LEVELS + i. Nodes without a leaf are omitted.
//
// The multiplicand enters LEVELS - 1 clocks after the stream, on a wire shared by all levels, so that at level k it has
// the weight h = 2^(LEVELS - 1 - k). There it is used from bit LEVELS - 1 - k of the stream on; until then the wire
// carries the end of the previous stream.
`include "faults.vh"

module multiplier_tree #(
  parameter LEAVES = 8,
  parameter LEVELS = 3,  // $clog2(LEAVES)
  parameter LANES = 1
) (
  input wire clk,
  input wire reset,
  input wire [LEVELS:0] begins,   // start of a stream at each level
  input wire multiplicand,
  input wire [LANES-1:0] in,
  output wire [LEAVES*LANES-1:0] out   // lanes of leaf 0 first, then of leaf 1, and so on
);
  localparam ROUNDED = 1 << LEVELS;
  /* verilator lint_off UNUSEDSIGNAL */
  wire [2*ROUNDED*LANES-1:0] stream;
  wire unused = clk | reset | multiplicand | |begins;
  /* verilator lint_on UNUSEDSIGNAL */
  assign stream[0 +: LANES] = {LANES{1'b0}};
  assign stream[LANES +: LANES] = in;
  assign out = stream[ROUNDED*LANES +: LEAVES*LANES];

  genvar k, i;
  generate
    for (k = 0; k < LEVELS; k = k + 1) begin : level
      wire counts;
      if (k + 1 < LEVELS) begin : late
        assign counts = ~|begins[LEVELS-2:k] | `FAULT(`FAULT_TREE_SELECT);
      end else begin : at_once
        assign counts = 1'b1;
      end
      for (i = 0; i < (1 << k); i = i + 1) begin : at
        localparam NODE = (1 << k) + i;
        if (i << (LEVELS - k) < LEAVES) begin : there
          tree_node #(.LANES(LANES)) node (
            .clk(clk), .reset(reset), .first(begins[k]), .multiplicand(multiplicand & counts),
            .in(stream[NODE*LANES +: LANES]), .left(stream[2*NODE*LANES +: LANES]),
            .right(stream[(2*NODE+1)*LANES +: LANES]));
        end else begin : missing
          assign stream[2*NODE*LANES +: 2*LANES] = {(2*LANES){1'b0}};
        end
      end
    end
  endgenerate
endmodule
