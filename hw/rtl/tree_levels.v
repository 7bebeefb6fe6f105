// Start of the streams in a multiplier tree of LEVELS levels: at level k (the root is level 0), k clocks after the
// root; the last level contains the leaves. MORE further clocks are also output, so that adjacent wires show the age of
// a stream: the stream at level k began less than m clocks ago if one of the m wires from begins[k] on is 1.
module tree_levels #(
  parameter LEVELS = 3,
  parameter MORE = 0
) (
  input wire clk,
  input wire reset,
  input wire first,                     // first bit of a stream at the root
  output wire [LEVELS+MORE:0] begins
);
  generate
    if (LEVELS + MORE == 0) begin : none
      assign begins = first;
      /* verilator lint_off UNUSEDSIGNAL */
      wire unused = clk | reset;
      /* verilator lint_on UNUSEDSIGNAL */
    end else begin : some
      reg [LEVELS+MORE:1] passed;
      assign begins = {passed, first};
      always @(posedge clk) passed <= reset ? {(LEVELS+MORE){1'b0}} : begins[LEVELS+MORE-1:0];
    end
  endgenerate
endmodule
