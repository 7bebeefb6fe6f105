// What a port of pixel memory decodes, once for all pixels of a chip: a clock before it is used the address of place 0 of
// the ALU comes, and in the clock itself the registers say which word line is chosen in each bank. Bit a of memory is in
// bank a mod BANKS, word a / BANKS, so that adjacent bits are in different banks.
`include "faults.vh"

module memory_port #(
  parameter ALU_BITS = 1,
  parameter BANKS = 1,     // ALU_BITS at least
  parameter ADDRESS = 7,
  parameter ROW = 7        // bits of a word's address in a bank
) (
  input wire clk,
  input wire [ADDRESS-1:0] early,
  output reg [BANKS*ROW-1:0] rows,         // of each bank, for the bit of the ALU's place that meets it
  output reg [ALU_BITS*BANKS-1:0] homes    // of each place: 1 for the bank that it meets
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
        localparam [31:0] BEFORE = (b - i + BANKS) % BANKS;  // the turn with which this place meets this bank
        always @(posedge clk) homes[i*BANKS + b] <= turn == BEFORE[ADDRESS:0];
      end
    end
  endgenerate
endmodule
