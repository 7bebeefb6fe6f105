`include "faults.vh"

// Adds two numbers word by word, lowest word first; the carry is stored between words.
module cell_adder #(
  parameter WORD_BITS = 32
) (
  input wire clk,
  input wire reset,
  input wire first,    // lowest word
  input wire add,      // a word arrives
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
