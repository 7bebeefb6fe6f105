// A serial multiplier tree (thesis 7.2.1 and fig. 7.1): adds multiplicand * i to the stream for each leaf i, LEVELS clocks
// later. Node 1 is the root, those below node n are 2n and 2n + 1, and leaf i is number 2^LEVELS + i. Nodes that have no
// leaf are left out.
//
// The multiplicand enters LEVELS - 1 clocks after the stream, on a wire that all levels share, so that at level k it is
// worth h = 2^(LEVELS - 1 - k) times itself. It counts there from bit LEVELS - 1 - k of the stream on; until then the wire
// has the end of the stream before.
`include "faults.vh"

module multiplier_tree #(
  parameter LEAVES = 8,
  parameter LEVELS = 3   // $clog2(LEAVES)
) (
  input wire clk,
  input wire reset,
  input wire [LEVELS:0] begins,   // a stream, at each level
  input wire multiplicand,
  input wire in,
  output wire [LEAVES-1:0] out
);
  localparam ROUNDED = 1 << LEVELS;
  /* verilator lint_off UNUSEDSIGNAL */
  wire [2*ROUNDED-1:0] stream;
  wire unused = clk | reset | multiplicand | |begins;
  /* verilator lint_on UNUSEDSIGNAL */
  assign stream[0] = 1'b0;
  assign stream[1] = in;
  assign out = stream[ROUNDED +: LEAVES];

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
        if (i << (LEVELS - k) < LEAVES) begin : there
          tree_node node (
            .clk(clk), .reset(reset), .first(begins[k]), .multiplicand(multiplicand & counts),
            .in(stream[(1 << k) + i]), .left(stream[2 * ((1 << k) + i)]), .right(stream[2 * ((1 << k) + i) + 1]));
        end else begin : missing
          assign stream[2 * ((1 << k) + i) +: 2] = 2'b00;
        end
      end
    end
  endgenerate
endmodule
