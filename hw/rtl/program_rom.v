// A host that consists of a ROM: it sends the words of a frame, as written by `csgsim rtl`, whenever the machine
// requests them. It behaves like the host's end of the link (docs/machines/pixel-planes.md, "Link"): a request names
// the instruction at which to resume; LATENCY clocks after the edge at which the request arrives, the first word is on
// the link, for WORD_CLOCKS clocks and then until there is room for it.
//
// WORDS_FILE contains one word of LINK bits per line, in hexadecimal, in the format of $readmemh. BEGINS_FILE contains,
// for each of INSTRUCTIONS instructions and for the end of the frame, the number of the word at which to resume when
// all earlier instructions are complete.
module program_rom #(
  parameter LINK = 32,
  parameter WORDS = 1,
  parameter INSTRUCTIONS = 1,
  parameter LATENCY = 0,
  parameter WORD_CLOCKS = 1,
  parameter FRAMES = 1,                 // number of times that the frame is drawn; 0: endless
  parameter WORDS_FILE = "",
  parameter BEGINS_FILE = ""
) (
  input wire clk,
  input wire reset,
  output wire frame,
  input wire request,
  input wire [31:0] request_from,
  output wire [LINK-1:0] word,
  output wire word_valid,
  input wire word_ready
);
  localparam PLACE = $clog2(WORDS + 1);
  localparam NUMBER = $clog2(INSTRUCTIONS + 1);
  localparam [31:0] END = WORDS;
  localparam [31:0] LAST = INSTRUCTIONS;
  localparam [31:0] WAY = LATENCY;
  localparam [31:0] EACH = WORD_CLOCKS > 1 ? WORD_CLOCKS : 1;
  localparam WAITS = $clog2(LATENCY + 1) > 0 ? $clog2(LATENCY + 1) : 1;
  localparam STAYS = $clog2(EACH + 1);
  localparam [31:0] TIMES = FRAMES;

  /* verilator lint_off UNDRIVEN */
  reg [LINK-1:0] words [0:WORDS-1];
  reg [PLACE-1:0] begins [0:INSTRUCTIONS];
  /* verilator lint_on UNDRIVEN */
  generate
    if (WORDS_FILE != "") begin : filled
      initial begin
        $readmemh(WORDS_FILE, words);
        $readmemh(BEGINS_FILE, begins);
      end
    end
  endgenerate

  reg [PLACE-1:0] next;     // index of the word on the link or, if there is none, of the next word
  reg [WAITS-1:0] latent;   // clocks until that word is on the link
  reg [STAYS-1:0] on_link;  // remaining clocks of the word on the link
  reg [31:0] frames;        // number of frames begun by the machine

  wire sends = latent == 0 && next != END[PLACE-1:0];
  assign frame = FRAMES == 0 || frames != TIMES;
  assign word = words[next];
  assign word_valid = sends && on_link == 1 && !request;

  always @(posedge clk) begin
    if (request) begin
      next <= request_from > LAST ? END[PLACE-1:0] : begins[request_from[NUMBER-1:0]];
      latent <= WAY[WAITS-1:0];
      on_link <= EACH[STAYS-1:0];
      if (request_from == 0 && FRAMES != 0) frames <= frames + 1;
    end else if (latent != 0) begin
      latent <= latent - 1;
    end else if (sends && on_link != 1) begin
      on_link <= on_link - 1;
    end else if (word_valid && word_ready) begin
      next <= next + 1;
      on_link <= EACH[STAYS-1:0];
    end
    if (reset) begin
      next <= END[PLACE-1:0];
      latent <= 0;
      frames <= 0;
    end
  end
endmodule
