// What goes in at an edge can be taken at the next, and a place that becomes free can be filled at the next.
module fifo #(
  parameter DEPTH = 16,
  parameter BITS = 32
) (
  input wire clk,
  input wire reset,
  input wire drop,  // all that is in at this edge
  input wire [BITS-1:0] in,
  input wire in_valid,
  output wire in_ready,
  output wire [BITS-1:0] out,
  output wire out_valid,
  input wire take
);
  localparam PLACE = DEPTH > 1 ? $clog2(DEPTH) : 1;
  localparam COUNT = $clog2(DEPTH + 1);
  reg [BITS-1:0] words [0:DEPTH-1];
  reg [PLACE-1:0] first;
  reg [PLACE-1:0] last;
  reg [COUNT-1:0] count;

  assign in_ready = count != DEPTH;
  assign out_valid = count != 0;
  assign out = words[first];
  wire push = in_valid & in_ready;

  always @(posedge clk) begin
    if (reset) begin
      first <= 0;
      last <= 0;
      count <= 0;
    end else begin
      if (push) begin
        words[last] <= in;
        last <= last == DEPTH - 1 ? 0 : last + 1;
      end
      if (drop) begin
        first <= last;
        count <= push;
      end else begin
        if (take) first <= first == DEPTH - 1 ? 0 : first + 1;
        count <= count + push - take;
      end
    end
  end
endmodule
