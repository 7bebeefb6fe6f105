`include "faults.vh"

module tree_node (
  input wire clk,
  input wire reset,
  input wire first,
  input wire multiplicand,
  input wire in,
  output reg left,
  output reg right
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
