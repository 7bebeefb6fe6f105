`include "faults.vh"

// What the levels of a tree share: where streams begin, and from when on the multiplicand counts. At level k that is from
// bit n - 1 - k of its stream on; until then the wire has the end of the stream before.
module tree_levels #(
  parameter LEVELS = 3
) (
  input wire clk,
  input wire reset,
  input wire first,                // a stream's first bit is at the root
  output wire [LEVELS:0] begins,   // or at level k; the last are the leaves
  output wire [LEVELS:0] counts
);
  reg [LEVELS:0] passed;
  assign begins = passed | first;
  always @(posedge clk) passed <= reset ? {(LEVELS+1){1'b0}} : begins << 1;

  genvar k;
  generate
    for (k = 0; k <= LEVELS; k = k + 1) begin : level
      // The stream at level k began j clocks ago if begins[k + j] is 1.
      if (k + 1 < LEVELS) assign counts[k] = ~|begins[LEVELS-2:k] | `FAULT(`FAULT_TREE_SELECT);
      else assign counts[k] = 1'b1;
    end
  endgenerate
endmodule
