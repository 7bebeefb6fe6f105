// A node of a multiplier tree (thesis 7.2.1 and fig. 7.1): a one-bit adder that keeps its carry. Streams come least
// significant bit first and back to back, and leave a clock later.
`include "faults.vh"

module tree_node (
  input wire clk,
  input wire reset,
  input wire first,         // bit of a stream
  input wire multiplicand,
  input wire in,
  output reg left,          // the same
  output reg right          // the sum
);
  reg carry;
  wire kept = carry & (~first | `FAULT(`FAULT_TREE_ADDER));
  always @(posedge clk) begin
    if (reset) begin
      left <= 1'b0;
      right <= 1'b0;
      carry <= 1'b0;
    end else begin
      left <= in;
      right <= in ^ multiplicand ^ kept;
      carry <= (in & multiplicand) | (in & kept) | (multiplicand & kept);
    end
  end
endmodule
