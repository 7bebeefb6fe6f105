// @MACHINE@, with the host at the other end of a serial line.
module system #(
  parameter BIT = 104  // clocks: 115,200 bits a second at 12 MHz
) (
  input wire clk,
  input wire reset,
  input wire from_computer,
  output wire to_computer,
@MACHINE_PORTS@);
  wire [@LINK@-1:0] word;
  wire word_valid, word_ready, frame, request;
  wire [31:0] request_from;

  uart_host #(.LINK(@LINK@), .BIT(BIT)) host (
    .clk(clk), .reset(reset), .from_computer(from_computer), .to_computer(to_computer), .frame(frame), .request(request),
    .request_from(request_from), .word(word), .word_valid(word_valid), .word_ready(word_ready), .told(told),
    .told_any(told_any), .done(done), .clocks(clocks));

@PIXEL_PLANES@endmodule
