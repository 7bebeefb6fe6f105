// The hosts of hw/rtl in Icarus: a Program is drawn by two machines, one with a ROM, and one fed over a serial line by
// the computer modelled here. Both must give the answers and the picture in the files written by rtl_8x8 host, and the
// first must take the clocks given by a parameter. Prints the errors, or "equal".
module host_test #(
  parameter WORDS = 1,
  parameter INSTRUCTIONS = 1,
  parameter ANSWERS = 0,
  parameter CLOCKS = 0,
  parameter LATENCY = 5,
  parameter WORD_CLOCKS = 2
);
  localparam BIT = 5;       // clocks per bit on the line
  localparam WINDOW = 3;
  localparam PIXELS = 64;
  localparam COLOUR_BITS = 20;
  localparam TICK = 10;

  reg clk = 0;
  reg reset = 1;
  always #(TICK / 2) clk = ~clk;
  initial #(TICK * 4) reset = 0;

  reg [31:0] words [0:WORDS-1];
  reg [31:0] begins [0:INSTRUCTIONS];
  reg answers [0:ANSWERS];
  reg [COLOUR_BITS-1:0] picture [0:PIXELS-1];
  initial begin
    $readmemh("words.hex", words);
    $readmemh("begins.hex", begins);
    $readmemh("answers.hex", answers);
    $readmemh("picture.hex", picture);
  end

  reg wrong = 0;
  task complain(input [8*40-1:0] what);
    begin
      $display("host_test: %0s", what);
      wrong = 1;
    end
  endtask

  // Machine 0 has the ROM; machine 1 is on the line.
  wire [1:0] frame, request, word_valid, word_ready, told, told_any, done, video_valid, video_frame, shown;
  wire [31:0] request_from [0:1];
  wire [31:0] word [0:1];
  wire [31:0] clocks [0:1];
  wire [3*COLOUR_BITS-1:0] video [0:1];
  reg from_computer = 1;
  wire to_computer;
  program_rom #(
    .LINK(32), .WORDS(WORDS), .INSTRUCTIONS(INSTRUCTIONS), .LATENCY(LATENCY), .WORD_CLOCKS(WORD_CLOCKS),
    .WORDS_FILE("words.hex"), .BEGINS_FILE("begins.hex")
  ) rom (
    .clk(clk), .reset(reset), .frame(frame[0]), .request(request[0]), .request_from(request_from[0]), .word(word[0]),
    .word_valid(word_valid[0]), .word_ready(word_ready[0]));
  uart_host #(.LINK(32), .BIT(BIT), .WINDOW(WINDOW)) serial (
    .clk(clk), .reset(reset), .from_computer(from_computer), .to_computer(to_computer), .frame(frame[1]),
    .request(request[1]), .request_from(request_from[1]), .word(word[1]), .word_valid(word_valid[1]),
    .word_ready(word_ready[1]), .told(told[1]), .told_any(told_any[1]), .done(done[1]), .clocks(clocks[1]));

  reg [1:0] finished = 0;
  genvar m;
  generate
    for (m = 0; m < 2; m = m + 1) begin : one
      wire video_row;
      pixel_planes #(
        .WIDTH(8), .HEIGHT(8), .MEMORY_BITS(40), .CLEAR_CLOCKS(40), .FAN_IN(8), .SCAN_PIXELS(3), .COLOUR_BITS(COLOUR_BITS)
      ) machine (
        .clk(clk), .reset(reset), .frame(frame[m]), .request(request[m]), .request_from(request_from[m]), .word(word[m]),
        .word_valid(word_valid[m]), .word_ready(word_ready[m]), .told(told[m]), .told_any(told_any[m]), .done(done[m]),
        .clocks(clocks[m]), .video_valid(video_valid[m]), .video_row(video_row), .video_frame(video_frame[m]),
        .video(video[m]), .shown(shown[m]));

      integer pixel = 0;
      integer answered = 0;
      integer i;
      always @(posedge clk) if (!reset) begin
        if (told[m]) begin
          if (answered >= ANSWERS || told_any[m] !== answers[answered]) complain("an answer");
          answered = answered + 1;
        end
        if (video_valid[m])
          for (i = 0; i < 3; i = i + 1)
            if (i < 2 || pixel % 8 != 0) begin  // a row of 8 is shown as 3, 3 and 2 pixels
              if (video[m][i*COLOUR_BITS +: COLOUR_BITS] !== picture[pixel]) complain("a pixel");
              pixel = pixel + 1;
            end
        if (done[m] && m == 0 && clocks[0] != CLOCKS) complain("the clocks");
        if (shown[m]) begin
          if (pixel != PIXELS) complain("the number of pixels");
          if (answered != ANSWERS) complain("the number of answers");
          finished[m] <= 1;
        end
      end
    end
  endgenerate

  // The computer's receiver.
  reg asks = 0;
  reg drawn = 0;
  integer from = 0;
  integer room = WINDOW;
  integer heard = 0;
  reg [7:0] byte_in;
  reg [31:0] number;
  integer b, n;
  task receive;
    begin
      @(negedge to_computer) #(TICK * BIT / 2);
      for (b = 0; b < 8; b = b + 1) #(TICK * BIT) byte_in[b] = to_computer;
      #(TICK * BIT) if (!to_computer) complain("a stop bit");
    end
  endtask
  task receive_number;
    for (n = 0; n < 4; n = n + 1) begin
      receive;
      number[8*n +: 8] = byte_in;
    end
  endtask
  always begin
    receive;
    case (byte_in)
      "K": room = room + 1;
      "A": begin
        receive;
        if (heard >= ANSWERS || byte_in != answers[heard]) complain("an answer on the line");
        heard = heard + 1;
      end
      "R": begin
        receive_number;
        from = number;
        room = WINDOW;
        asks = 1;
      end
      "D": begin
        receive_number;
        if (number != clocks[1]) complain("the clocks on the line");
        if (heard != ANSWERS) complain("the number of answers on the line");
        drawn = 1;
      end
      default: complain("an unknown message");
    endcase
  end

  // The computer's sender.
  integer next = WORDS;
  integer s, p;
  task send(input [7:0] value);
    begin
      from_computer = 0;
      for (s = 0; s < 8; s = s + 1) #(TICK * BIT) from_computer = value[s];
      #(TICK * BIT) from_computer = 1;
      #(TICK * BIT);
    end
  endtask
  initial begin
    #(TICK * 20) send("F");
    while (!drawn) begin
      if (asks) begin
        asks = 0;
        next = begins[from];
        send("S");
      end else if (next < WORDS && room > 0) begin
        room = room - 1;
        send("W");
        for (p = 0; p < 4; p = p + 1) send(words[next][8*p +: 8]);
        next = next + 1;
      end else begin
        #TICK;
      end
    end
    while (finished != 2'b11) #TICK;
    if (!wrong) $display("equal");
    $finish(0);
  end
  initial begin
    #(TICK * 2000000) $display("host_test: no end");
    $finish(0);
  end
endmodule
