`include "faults.vh"

// The memory of a cell. In a clock, each port reads a word or writes bits of a word. A read returns the content before
// the edge. No two ports may write the same word.
module cell_memory #(
  parameter WORD_BITS = 32,
  parameter WORDS = 3,
  parameter PORTS = 1,
  parameter CLEARS_AT_ONCE = 0,
  parameter ADDRESS = 2
) (
  input wire clk,
  /* verilator lint_off UNUSEDSIGNAL */
  input wire clear,                          // clears all words; used if CLEARS_AT_ONCE is 1
  /* verilator lint_on UNUSEDSIGNAL */
  input wire [PORTS*ADDRESS-1:0] address,
  input wire [PORTS*WORD_BITS-1:0] mask,     // bits to write
  input wire [PORTS-1:0] write,
  input wire [PORTS*WORD_BITS-1:0] written,
  output wire [PORTS*WORD_BITS-1:0] read
);
  localparam [WORD_BITS-1:0] UPPERMOST = {WORD_BITS{1'b1}} ^ ({WORD_BITS{1'b1}} >> 1);
  wire [WORDS*WORD_BITS-1:0] words;
  genvar w, p;
  generate
    for (w = 0; w < WORDS; w = w + 1) begin : word
      localparam [ADDRESS-1:0] HERE = w[ADDRESS-1:0];
      reg [WORD_BITS-1:0] cells;
      wire [PORTS*WORD_BITS-1:0] bits;
      wire [WORD_BITS-1:0] changed;
      wire [WORD_BITS-1:0] into;
      for (p = 0; p < PORTS; p = p + 1) begin : port
        wire selected = write[p] && address[p*ADDRESS +: ADDRESS] == HERE;
        assign bits[p*WORD_BITS +: WORD_BITS] =
          mask[p*WORD_BITS +: WORD_BITS] & {WORD_BITS{selected}} & ~(UPPERMOST & {WORD_BITS{`CELL_FAULT(`FAULT_WRITE_MASK)}});
      end
      or_words #(.WORD_BITS(WORD_BITS), .COUNT(PORTS)) any_change (.in(bits), .out(changed));
      or_words #(.WORD_BITS(WORD_BITS), .COUNT(PORTS)) any_one (.in(bits & written), .out(into));
      always @(posedge clk)
        if (CLEARS_AT_ONCE != 0 && clear && !(w == WORDS - 1 && `CELL_FAULT(`FAULT_CLEAR))) cells <= {WORD_BITS{1'b0}};
        else cells <= (cells & ~changed) | into;
      assign words[w*WORD_BITS +: WORD_BITS] = cells;
    end

    for (p = 0; p < PORTS; p = p + 1) begin : reader
      wire [WORDS*WORD_BITS-1:0] gated;
      for (w = 0; w < WORDS; w = w + 1) begin : word
        localparam [ADDRESS-1:0] HERE = w[ADDRESS-1:0];
        assign gated[w*WORD_BITS +: WORD_BITS] =
          words[w*WORD_BITS +: WORD_BITS] & {WORD_BITS{address[p*ADDRESS +: ADDRESS] == HERE}};
      end
      or_words #(.WORD_BITS(WORD_BITS), .COUNT(WORDS)) any (.in(gated), .out(read[p*WORD_BITS +: WORD_BITS]));
    end
  endgenerate
endmodule
