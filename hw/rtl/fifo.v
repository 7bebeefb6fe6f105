// A FIFO of DEPTH words of BITS bits, as that of the link (docs/machines/pixel-planes.md, "Link"). What goes in at an
// edge can be taken at the next, and a place that becomes free at an edge can be filled at the next.
`include "faults.vh"

module fifo #(
  parameter DEPTH = 16,
  parameter BITS = 32
) (
  input wire clk,
  input wire reset,
  input wire drop,            // all that is in before this edge
  input wire [BITS-1:0] in,
  input wire in_valid,
  output wire in_ready,
  output wire [BITS-1:0] out,
  output wire out_valid,
  input wire take             // out; only where it is valid
);
  localparam PLACE = DEPTH > 1 ? $clog2(DEPTH) : 1;
  localparam COUNT = $clog2(DEPTH + 1);
  localparam [31:0] FULL = DEPTH;
  localparam [31:0] END = DEPTH - 1;
  reg [BITS-1:0] words [0:DEPTH-1];
  reg [PLACE-1:0] first;
  reg [PLACE-1:0] last;
  reg [COUNT-1:0] count;

  assign in_ready = count != FULL[COUNT-1:0];
  assign out_valid = count != 0;
  assign out = words[first];
  wire push = in_valid & in_ready;
  wire drops = drop & ~`FAULT(`FAULT_DROP);
  wire [COUNT-1:0] one = 1;
  wire [PLACE-1:0] next = 1;

  always @(posedge clk) if (push) words[last] <= in;

  always @(posedge clk) begin
    if (reset) begin
      first <= 0;
      last <= 0;
      count <= 0;
    end else begin
      if (push) last <= last == END[PLACE-1:0] ? 0 : last + next;
      if (drops) first <= last;
      else if (take) first <= first == END[PLACE-1:0] ? 0 : first + next;
      if (drops) count <= push ? one : 0;
      else if (push & ~take) count <= count + one;
      else if (take & ~push) count <= count - one;
    end
  end
endmodule
