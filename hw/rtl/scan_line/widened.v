// Extends a number with zeros at the top.
module widened #(
  parameter FROM = 64,
  parameter TO = 96
) (
  input wire [FROM-1:0] in,
  output wire [TO-1:0] out
);
  generate
    if (TO > FROM) begin : more
      assign out = {{TO - FROM{1'b0}}, in};
    end else begin : same
      assign out = in;
    end
  endgenerate
endmodule
