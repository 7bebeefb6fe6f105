`include "faults.vh"

// The register of an operand, and its value in this clock including the words that arrive. Also outputs the word that
// the shifter moves and its neighbours above and below.
module cell_operand #(
  parameter WORD_BITS = 32,
  parameter COUNT = 3,           // number of words
  parameter INDEX = 2
) (
  input wire clk,
  input wire reset,
  input wire first,              // first clock: the register reads as 0
  input wire [COUNT-1:0] take,   // words that arrive
  input wire [COUNT*WORD_BITS-1:0] in,
  input wire move,               // the shifter's output replaces this word
  input wire [INDEX-1:0] index,
  /* verilator lint_off UNUSEDSIGNAL */
  input wire empties,            // also clears the word above
  /* verilator lint_on UNUSEDSIGNAL */
  input wire [WORD_BITS-1:0] shifted,
  output wire [WORD_BITS-1:0] word,
  output wire [WORD_BITS-1:0] above,
  output wire [WORD_BITS-1:0] below,
  output wire [COUNT*WORD_BITS-1:0] seen,    // value before a move
  output wire [COUNT*WORD_BITS-1:0] moved,   // value after a move
  input wire [COUNT*WORD_BITS-1:0] next      // value of the next clock
);
  genvar w;
  reg [COUNT*WORD_BITS-1:0] value;
  wire [COUNT*WORD_BITS-1:0] selected;
  wire [COUNT*WORD_BITS-1:0] from_above;
  wire [COUNT*WORD_BITS-1:0] from_below;
  wire [COUNT-1:0] here;
  assign from_above[(COUNT-1)*WORD_BITS +: WORD_BITS] = {WORD_BITS{1'b0}};
  assign from_below[0 +: WORD_BITS] = {WORD_BITS{1'b0}};
  generate
    for (w = 0; w < COUNT; w = w + 1) begin : each
      localparam [INDEX-1:0] HERE = w[INDEX-1:0];
      assign here[w] = index == HERE;
      assign seen[w*WORD_BITS +: WORD_BITS] =
        take[w] ? in[w*WORD_BITS +: WORD_BITS] : first ? {WORD_BITS{1'b0}} : value[w*WORD_BITS +: WORD_BITS];
      assign selected[w*WORD_BITS +: WORD_BITS] = seen[w*WORD_BITS +: WORD_BITS] & {WORD_BITS{here[w]}};
      if (w > 0) begin : neighbours
        assign from_above[(w-1)*WORD_BITS +: WORD_BITS] = seen[w*WORD_BITS +: WORD_BITS] & {WORD_BITS{here[w-1]}};
        assign from_below[w*WORD_BITS +: WORD_BITS] = seen[(w-1)*WORD_BITS +: WORD_BITS] & {WORD_BITS{here[w]}};
      end
      wire emptied;
      if (w == 0) begin : lowest
        assign emptied = 1'b0;
      end else begin : higher
        assign emptied = empties && here[w-1];
      end
      assign moved[w*WORD_BITS +: WORD_BITS] =
        move && here[w] && !(w == 1 && `CELL_FAULT(`FAULT_MOVE_WORD)) ? shifted :
        move && emptied ? {WORD_BITS{1'b0}} : seen[w*WORD_BITS +: WORD_BITS];
    end
  endgenerate

  or_words #(.WORD_BITS(WORD_BITS), .COUNT(COUNT)) the_word (.in(selected), .out(word));
  or_words #(.WORD_BITS(WORD_BITS), .COUNT(COUNT)) the_above (.in(from_above), .out(above));
  or_words #(.WORD_BITS(WORD_BITS), .COUNT(COUNT)) the_below (.in(from_below), .out(below));

  always @(posedge clk)
    if (reset) value <= {COUNT * WORD_BITS{1'b0}};
    else value <= next;
endmodule
