`include "faults.vh"

// The bitwise OR of COUNT words.
module or_words #(
  parameter WORD_BITS = 32,
  parameter COUNT = 3
) (
  input wire [COUNT*WORD_BITS-1:0] in,
  output reg [WORD_BITS-1:0] out
);
  integer i;
  always @* begin
    out = {WORD_BITS{1'b0}};
    for (i = 0; i < COUNT; i = i + 1)
      if (!(i == 2 && `CELL_FAULT(`FAULT_OR))) out = out | in[i*WORD_BITS +: WORD_BITS];
  end
endmodule
