// Receives bytes from a serial line: 8 data bits, least significant first, no parity, one stop bit; BIT clocks per bit,
// at least 4.
module uart_receiver #(
  parameter BIT = 104
) (
  input wire clk,
  input wire reset,
  input wire line,          // 1 when idle
  output reg [7:0] value,
  output reg valid          // 1 for one clock; a byte whose stop bit is 0 is dropped
);
  localparam [31:0] FULL = BIT - 1;
  localparam [31:0] HALF = BIT / 2 - 1;
  reg [1:0] settled;        // synchronizer, because the line is asynchronous
  reg [15:0] clocks;        // clocks until the next bit is sampled
  reg [3:0] bits;           // number of bits not received yet, including the start bit; 0 if there are none
  wire now = settled[1];

  always @(posedge clk) begin
    settled <= {settled[0], line};
    valid <= 1'b0;
    if (bits == 0) begin
      clocks <= HALF[15:0];
      if (!now) bits <= 4'd10;
    end else if (clocks != 0) begin
      clocks <= clocks - 16'd1;
    end else begin
      clocks <= FULL[15:0];
      bits <= bits == 4'd10 && now ? 4'd0 : bits - 4'd1;  // not a start bit
      if (bits == 4'd1) valid <= now;
      else value <= {now, value[7:1]};
    end
    if (reset) begin
      settled <= 2'b11;
      bits <= 4'd0;
      valid <= 1'b0;
    end
  end
endmodule
