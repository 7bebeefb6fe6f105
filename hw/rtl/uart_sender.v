// Sends bytes to a serial line: 8 data bits, least significant first, no parity, one stop bit; BIT clocks per bit.
module uart_sender #(
  parameter BIT = 104
) (
  input wire clk,
  input wire reset,
  input wire [7:0] value,
  input wire valid,
  output wire ready,        // accepts a byte at this edge
  output wire line
);
  localparam [31:0] FULL = BIT - 1;
  reg [8:0] rest;           // remaining bits; the bit on the line is the lowest
  reg [15:0] clocks;
  reg [3:0] bits;           // number of bits on the line and after it
  assign ready = bits == 0;
  assign line = bits == 0 || rest[0];

  always @(posedge clk) begin
    if (ready) begin
      clocks <= FULL[15:0];
      if (valid) begin
        rest <= {value, 1'b0};
        bits <= 4'd10;
      end
    end else if (clocks != 0) begin
      clocks <= clocks - 16'd1;
    end else begin
      clocks <= FULL[15:0];
      rest <= {1'b1, rest[8:1]};
      bits <= bits - 4'd1;
    end
    if (reset) bits <= 4'd0;
  end
endmodule
