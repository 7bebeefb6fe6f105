// Delays each control word by LATENCY registers (at least 1), one for each level of the trees, so that it reaches the
// pixels together with the bits of F that entered the trees with it (thesis 7.2.1). One clock earlier the word is on
// `early`, so that memory addresses can be decoded into registers in time.
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
