// Decodes the address of a port of pixel memory, once for all pixels of a chip. The address of the ALU's place 0
// arrives one clock before its use; in the clock of its use, registers select the word line of each bank. Bit a of
// memory is in bank a mod BANKS, word a / BANKS, so that adjacent bits are in different banks.
`include "faults.vh"

module memory_port #(
  parameter ALU_BITS = 1,
  parameter BANKS = 1,     // at least ALU_BITS
  parameter ADDRESS = 7,
  parameter ROW = 7        // bits of a word address within a bank
) (
  input wire clk,
  input wire [ADDRESS-1:0] early,
  output reg [BANKS*ROW-1:0] rows,         // per bank: word of the bit for the ALU place that uses the bank
  output reg [ALU_BITS*BANKS-1:0] homes    // per place: 1 for the bank that it uses
);
  localparam [31:0] NUMBER = BANKS;
  localparam [ADDRESS:0] N = NUMBER[ADDRESS:0];
  /* verilator lint_off UNUSEDSIGNAL */
  wire [ADDRESS:0] start = {1'b0, early};
  wire [ADDRESS:0] row = start / N;
  wire [ADDRESS:0] turn = start % N;
  /* verilator lint_on UNUSEDSIGNAL */

  genvar b, i;
  generate
    for (b = 0; b < BANKS; b = b + 1) begin : bank
      localparam [31:0] BANK = b;
      /* verilator lint_off UNUSEDSIGNAL */
      wire [ADDRESS:0] here = row + (BANK[ADDRESS:0] < turn & ~`FAULT(`FAULT_BANK) ? 1 : 0);
      /* verilator lint_on UNUSEDSIGNAL */
      always @(posedge clk) rows[b*ROW +: ROW] <= here[ROW-1:0];
      for (i = 0; i < ALU_BITS; i = i + 1) begin : place
        localparam [31:0] BEFORE = (b - i + BANKS) % BANKS;  // value of `turn` for which this place uses this bank
        always @(posedge clk) homes[i*BANKS + b] <= turn == BEFORE[ADDRESS:0];
      end
    end
  endgenerate
endmodule
