// @MACHINE@, with a Program in the host's memory.
module system (
  input wire clk,
  input wire reset,
  output wire request,
  output wire [31:0] request_from,
@MACHINE_PORTS@);
  wire [@LINK@-1:0] word;
  wire word_valid, word_ready, frame;

  program_rom #(
    .LINK(@LINK@), .WORDS(@WORDS@), .INSTRUCTIONS(@INSTRUCTIONS@),
    .LATENCY(@LATENCY@),          // link.latency
    .WORD_CLOCKS(@WORD_CLOCKS@),  // link.word_clocks
    .FRAMES(0),              // unlimited
    .WORDS_FILE("program.hex"), .BEGINS_FILE("begins.hex")
  ) host (
    .clk(clk), .reset(reset), .frame(frame), .request(request), .request_from(request_from), .word(word), .word_valid(word_valid),
    .word_ready(word_ready));

@PIXEL_PLANES@endmodule
