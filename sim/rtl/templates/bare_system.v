// @MACHINE@, whose host is at the other end of a serial line.
module system #(
  parameter CLOCKS_A_BIT = 104  // of the line: 115,200 bits a second at 12 MHz
) (
  input wire clk,
  input wire reset,
  input wire receive,
  output wire send,
  output wire told,
  output wire told_any,
  output wire done,
  output wire [31:0] clocks,
  output wire video_valid,
  output wire video_row,
  output wire video_frame,
  output wire [@VIDEO_WIRES@-1:0] video,
  output wire shown
);
  wire [@LINK@-1:0] word;
  wire word_valid, word_ready, frame, request;
  wire [31:0] request_from;

  uart_host #(.LINK(@LINK@), .CLOCKS_A_BIT(CLOCKS_A_BIT)) host (
    .clk(clk), .reset(reset), .receive(receive), .send(send), .frame(frame), .request(request),
    .request_from(request_from), .word(word), .word_valid(word_valid), .word_ready(word_ready));

@PIXEL_PLANES@endmodule
