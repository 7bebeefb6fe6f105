// The control word of each clock on its way to the pixels, where it meets the bits of F that entered the trees with it:
// LATENCY registers, 1 at least, one for each level of the trees (thesis 7.2.1). A clock before, `early` has the word,
// so that what decodes addresses of memory has them in registers of its own when the word is there.
module control_delay #(
  parameter LATENCY = 6,
  parameter BITS = 64
) (
  input wire clk,
  input wire reset,
  input wire [BITS-1:0] in,
  output wire [BITS-1:0] early,
  output wire [BITS-1:0] out
);
  delay #(.LENGTH(LATENCY - 1), .BITS(BITS)) way (.clk(clk), .reset(reset), .in(in), .out(early));
  delay #(.LENGTH(1), .BITS(BITS)) at_pixels (.clk(clk), .reset(reset), .in(early), .out(out));
endmodule
