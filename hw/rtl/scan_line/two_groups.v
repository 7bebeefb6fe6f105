`include "faults.vh"

// Selects a group of LANES bits of a vector and the next group.
module two_groups #(
  parameter LANES = 32,
  parameter GROUPS = 3,
  parameter GROUP = 2,
  parameter BITS = 96
) (
  input wire [GROUP-1:0] group,
  input wire [BITS-1:0] in,
  output wire [2*LANES-1:0] out
);
  localparam PADDED = (GROUPS + 1) * LANES;   // more than BITS
  wire [PADDED-1:0] padded = {{PADDED - BITS{1'b0}}, in};
  wire [GROUPS*2*LANES-1:0] gated;
  genvar g;
  generate
    for (g = 0; g < GROUPS; g = g + 1) begin : each
      localparam [GROUP-1:0] HERE = g[GROUP-1:0];
      assign gated[g*2*LANES +: 2*LANES] = padded[g*LANES +: 2*LANES] & {2 * LANES{group == HERE}};
    end
  endgenerate
  wire [2*LANES-1:0] both;
  or_words #(.WORD_BITS(2 * LANES), .COUNT(GROUPS)) any (.in(gated), .out(both));
  assign out = `CELL_FAULT(`FAULT_NEXT_GROUP) ? {{LANES{1'b0}}, both[0 +: LANES]} : both;
endmodule
