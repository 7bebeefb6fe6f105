`include "faults.vh"

// Routes the words of the ports to their positions in an operand.
module port_words #(
  parameter WORD_BITS = 32,
  parameter PORTS = 1,
  parameter COUNT = 3
) (
  input wire [PORTS*COUNT-1:0] takes,      // per port: position of its word, one-hot
  input wire [PORTS*WORD_BITS-1:0] words,
  output wire [COUNT-1:0] taken,
  output wire [COUNT*WORD_BITS-1:0] out
);
  genvar w, p;
  generate
    for (w = 0; w < COUNT; w = w + 1) begin : each
      wire [PORTS-1:0] from;
      wire [PORTS*WORD_BITS-1:0] gated;
      for (p = 0; p < PORTS; p = p + 1) begin : port
        assign from[p] = takes[p*COUNT + w] && !(p == PORTS - 1 && `CELL_FAULT(`FAULT_LAST_PORT));
        assign gated[p*WORD_BITS +: WORD_BITS] = words[p*WORD_BITS +: WORD_BITS] & {WORD_BITS{from[p]}};
      end
      assign taken[w] = |from;
      or_words #(.WORD_BITS(WORD_BITS), .COUNT(PORTS)) any (.in(gated), .out(out[w*WORD_BITS +: WORD_BITS]));
    end
  endgenerate
endmodule
