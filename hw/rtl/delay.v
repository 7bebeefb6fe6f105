// Delays BITS wires by LENGTH registers in series.
module delay #(
  parameter LENGTH = 0,
  parameter BITS = 1
) (
  input wire clk,
  input wire reset,
  input wire [BITS-1:0] in,
  output wire [BITS-1:0] out
);
  generate
    if (LENGTH == 0) begin : none
      assign out = in;
      /* verilator lint_off UNUSEDSIGNAL */
      wire unused = clk | reset;
      /* verilator lint_on UNUSEDSIGNAL */
    end else begin : some
      reg [LENGTH*BITS-1:0] line;
      assign out = line[(LENGTH-1)*BITS +: BITS];
      if (LENGTH == 1) begin : one
        always @(posedge clk) line <= reset ? {BITS{1'b0}} : in;
      end else begin : several
        always @(posedge clk) line <= reset ? {(LENGTH*BITS){1'b0}} : {line[(LENGTH-1)*BITS-1:0], in};
      end
    end
  endgenerate
endmodule
