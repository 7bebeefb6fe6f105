// The nodes of LANES multiplier trees (thesis 7.2.1 and fig. 7.1) at one position: each is a one-bit adder that stores
// its carry. Streams arrive without gaps, least significant bit first, and leave one clock later.
`include "faults.vh"

module tree_node #(
  parameter LANES = 1
) (
  input wire clk,
  input wire reset,
  input wire first,         // first bit of a stream
  input wire multiplicand,
  input wire [LANES-1:0] in,
  output reg [LANES-1:0] left,    // the unchanged stream
  output reg [LANES-1:0] right    // the sum
);
  reg [LANES-1:0] carry;
  wire [LANES-1:0] kept = carry & {LANES{~first | `FAULT(`FAULT_TREE_ADDER)}};
  wire [LANES-1:0] added = {LANES{multiplicand}};
  always @(posedge clk) begin
    if (reset) begin
      left <= {LANES{1'b0}};
      right <= {LANES{1'b0}};
      carry <= {LANES{1'b0}};
    end else begin
      left <= in;
      right <= in ^ added ^ kept;
      carry <= (in & added) | (in & kept) | (added & kept);
    end
  end
endmodule
