// A host behind a serial line (uart_receiver.v: 8N1, BIT clocks per bit), so that a computer can feed a board. Messages
// are bytes; numbers are sent least significant byte first.
//
//   to the board                          to the computer
//   'F'            a frame is available   'R' and 4 bytes   send the words from that instruction of the frame on
//   'S'            answers an 'R'         'K'               the machine has taken a word
//   'W' and bytes  a word                 'A' and 1 byte    the answer to a question: is any pixel enabled?
//                                         'D' and 4 bytes   the frame is done, after that number of clocks
//
// A word has the number of bytes that its LINK bits need. Words sent before an 'S' are dropped: 'S' is sent once for
// each 'R', before the requested words. The computer keeps at most WINDOW words unacknowledged by a 'K' since the 'S',
// so nothing is lost, however long the machine takes. Unknown bytes at the start of a message are skipped.
module uart_host #(
  parameter LINK = 32,
  parameter BIT = 104,        // 115,200 bits per second at 12 MHz
  parameter WINDOW = 16,      // words
  // Capacity for answers not sent yet: at least the words held by the machine and this module.
  parameter ANSWERS = 64
) (
  input wire clk,
  input wire reset,
  input wire from_computer,   // serial lines
  output wire to_computer,
  output wire frame,
  input wire request,
  input wire [31:0] request_from,
  output wire [LINK-1:0] word,
  output wire word_valid,
  input wire word_ready,
  input wire told,
  input wire told_any,
  input wire done,
  input wire [31:0] clocks
);
  localparam BYTES = (LINK + 7) / 8;
  localparam [31:0] LAST = BYTES - 1;
  localparam [7:0] FRAME = "F", START = "S", WORD = "W", ASK = "R", TAKEN = "K", ANSWER = "A", DONE = "D";

  // Messages from the computer.
  wire [7:0] got;
  wire got_valid;
  uart_receiver #(.BIT(BIT)) receiver (
    .clk(clk), .reset(reset), .line(from_computer), .value(got), .valid(got_valid));

  reg waits;                  // a frame is available
  reg stopped;                // incoming words belong to an earlier request and are dropped
  reg in_word;
  reg [5:0] byte_number;
  /* verilator lint_off UNUSEDSIGNAL */
  reg [8*BYTES-1:0] gathered;
  wire [8*BYTES-1:0] gathered_now = {got, gathered[8*BYTES-1:8]};
  /* verilator lint_on UNUSEDSIGNAL */
  wire ends_word = got_valid && in_word && byte_number == LAST[5:0];
  assign frame = waits;

  always @(posedge clk) begin
    if (got_valid) begin
      if (in_word) begin
        gathered <= gathered_now;
        byte_number <= byte_number + 6'd1;
        if (ends_word) in_word <= 1'b0;
      end else begin
        in_word <= got == WORD;
        byte_number <= 6'd0;
        if (got == FRAME) waits <= 1'b1;
        if (got == START) stopped <= 1'b0;
      end
    end
    if (request) begin
      stopped <= 1'b1;
      if (request_from == 0) waits <= 1'b0;
    end
    if (reset) begin
      waits <= 1'b0;
      stopped <= 1'b1;
      in_word <= 1'b0;
    end
  end

  // Words to the machine.
  wire queued;
  /* verilator lint_off UNUSEDSIGNAL */
  wire room;
  /* verilator lint_on UNUSEDSIGNAL */
  assign word_valid = queued & ~request;
  wire taken = word_valid & word_ready;
  fifo #(.DEPTH(WINDOW), .BITS(LINK)) waiting (
    .clk(clk), .reset(reset), .drop(request), .in(gathered_now[LINK-1:0]), .in_valid(ends_word & ~stopped & ~request),
    .in_ready(room), .out(word), .out_valid(queued), .take(taken));

  // Messages to the computer: per kind of message, the data still to be sent.
  localparam COUNT = $clog2(WINDOW + 1);
  reg asks, ends;
  reg [31:0] from;
  reg [31:0] spent;
  reg [COUNT-1:0] acknowledged;
  reg [31:0] number;          // number being sent
  reg [2:0] bytes;            // number of its bytes not sent yet
  reg [7:0] value;
  reg valid;
  wire ready;
  uart_sender #(.BIT(BIT)) sender (
    .clk(clk), .reset(reset), .value(value), .valid(valid), .ready(ready), .line(to_computer));
  wire next = !valid || ready;                       // the next byte can be output
  wire answers, answer;
  /* verilator lint_off UNUSEDSIGNAL */
  wire answer_room;
  /* verilator lint_on UNUSEDSIGNAL */
  fifo #(.DEPTH(ANSWERS), .BITS(1)) answered (
    .clk(clk), .reset(reset), .drop(1'b0), .in(told_any), .in_valid(told), .in_ready(answer_room), .out(answer),
    .out_valid(answers), .take(next && bytes == 0 && answers));
  wire sends_taken = next && bytes == 0 && !answers && !ends && !asks && acknowledged != 0;

  always @(posedge clk) begin
    if (next) begin
      valid <= bytes != 0 || answers || ends || asks || acknowledged != 0;
      if (bytes != 0) begin
        value <= number[7:0];
        number <= number >> 8;
        bytes <= bytes - 3'd1;
      end else if (answers) begin
        value <= ANSWER;
        number <= {31'd0, answer};
        bytes <= 3'd1;
      end else if (ends) begin
        value <= DONE;
        number <= spent;
        bytes <= 3'd4;
        ends <= 1'b0;
      end else if (asks) begin
        value <= ASK;
        number <= from;
        bytes <= 3'd4;
        asks <= 1'b0;
      end else begin
        value <= TAKEN;
      end
    end
    if (request) acknowledged <= 0;
    else if (taken & ~sends_taken) acknowledged <= acknowledged + 1;
    else if (sends_taken & ~taken) acknowledged <= acknowledged - 1;
    if (request) begin
      asks <= 1'b1;
      from <= request_from;
    end
    if (done) begin
      ends <= 1'b1;
      spent <= clocks;
    end
    if (reset) begin
      {asks, ends, valid} <= 3'b000;
      acknowledged <= 0;
      bytes <= 3'd0;
    end
  end
endmodule
