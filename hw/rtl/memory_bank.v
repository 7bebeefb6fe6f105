// Words of one bit at each of PIXELS pixels: a word line corresponds to an address, a bit line to a pixel. Each port
// has a registered row address whose data is read in the same clock, so that block RAM, which samples addresses at an
// edge, can implement it. A read returns data written at the previous edge; synthesis adds registers to a RAM without
// this property.
module memory_bank #(
  parameter PIXELS = 64,
  parameter WORDS = 72,
  parameter ROW = 7,
  parameter PORTS = 1          // number of read ports
) (
  input wire clk,
  input wire [PORTS*ROW-1:0] rows,
  output wire [PORTS*PIXELS-1:0] read,
  input wire write,
  input wire [ROW-1:0] row,
  input wire [PIXELS-1:0] written,
  input wire [PIXELS-1:0] mask  // pixels to write
);
  localparam DEPTH = WORDS > 1 ? 1 << ROW : 1;
  reg [PIXELS-1:0] words [0:DEPTH-1];

  genvar i;
  generate
    for (i = 0; i < PORTS; i = i + 1) begin : port
      assign read[i*PIXELS +: PIXELS] = words[rows[i*ROW +: ROW]];
    end
  endgenerate

  // Two equivalent forms: synthesis infers a RAM's write mask from the first; the second simulates faster.
`ifdef SYNTHESIS
  integer j;
  always @(posedge clk)
    for (j = 0; j < PIXELS; j = j + 1)
      if (write & mask[j]) words[row][j] <= written[j];
`else
  always @(posedge clk) if (write) words[row] <= (words[row] & ~mask) | (written & mask);
`endif
endmodule
