`include "faults.vh"

// Adds a number to another word by word, the lowest first, with the carry kept from word to word.
module cell_adder #(
  parameter WORD_BITS = 32
) (
  input wire clk,
  input wire reset,
  input wire first,    // the lowest word
  input wire add,      // a word comes in
  input wire [WORD_BITS-1:0] one,
  input wire [WORD_BITS-1:0] other,
  output wire [WORD_BITS-1:0] sum
);
  reg carry;
  wire carry_in = carry && (!first || `CELL_FAULT(`FAULT_SUM_CARRY)) && !`CELL_FAULT(`FAULT_WORD_CARRY);
  wire carry_out;
  assign {carry_out, sum} = {1'b0, one} + {1'b0, other} + {{WORD_BITS{1'b0}}, carry_in};

  always @(posedge clk)
    if (reset) carry <= 1'b0;
    else if (add) carry <= carry_out;
endmodule
