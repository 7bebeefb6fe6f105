`include "faults.vh"

// Shifts a word by `amount` bits. Bits shifted in come from the adjacent word, after the `moved` bits shifted in
// earlier.
module cell_shifter #(
  parameter WORD_BITS = 32,
  parameter BIT = 5,
  parameter AMOUNT = 6
) (
  input wire left,
  input wire [AMOUNT-1:0] amount,
  input wire [BIT-1:0] moved,
  input wire [WORD_BITS-1:0] word,
  input wire [WORD_BITS-1:0] above,
  input wire [WORD_BITS-1:0] below,
  output wire [WORD_BITS-1:0] out
);
  wire [WORD_BITS-1:0] from_above = `CELL_FAULT(`FAULT_SHIFT_BESIDE) ? {WORD_BITS{1'b0}} : above >> moved;
  wire [WORD_BITS-1:0] from_below = `CELL_FAULT(`FAULT_SHIFT_LEFT) ? {WORD_BITS{1'b0}} : below << moved;
  /* verilator lint_off UNUSEDSIGNAL */
  wire [2*WORD_BITS-1:0] lower = {from_above, word} >> amount;
  wire [2*WORD_BITS-1:0] higher = {word, from_below} << amount;
  /* verilator lint_on UNUSEDSIGNAL */
  assign out = left ? higher[WORD_BITS +: WORD_BITS] : lower[0 +: WORD_BITS];
endmodule
