// The receiver assembles commands: the command it shows consists of the words received over the link since the last one
// was taken. It is complete exactly when the number of words in the table of docs/instruction-set.md has arrived, and
// no word is accepted while a complete command waits. `command_bits` is generated from that table. Assumptions: each
// command is in the table, incomplete commands are not taken, and no expression is wider than a command's register.
module receiver_check #(
  parameter LINK = 24
) (
  input wire clk,
  input wire reset,
  input wire drop,
  input wire [LINK-1:0] word,
  input wire word_valid,
  input wire take
);
`include "command.vh"
`include "command_bits.vh"
  localparam WORDS = (COMMAND_BITS + LINK - 1) / LINK;
  wire take_word, whole;
  wire [COMMAND_BITS-1:0] command;
  receiver #(.LINK(LINK)) dut (
    .clk(clk), .reset(reset), .drop(drop), .word(word), .word_valid(word_valid), .take_word(take_word), .whole(whole),
    .command(command), .take(take));

  reg begun = 1'b0;
  reg [WORDS*LINK-1:0] sent;  // since the last command was taken
  reg [8:0] words;
  always @(posedge clk) begin
    begun <= 1'b1;
    if (reset | drop) begin
      sent <= 0;
      words <= 0;
    end else if (take) begin
      sent <= take_word ? word : 0;
      words <= take_word;
    end else if (take_word) begin
      sent[words*LINK +: LINK] <= word;
      words <= words + 1;
    end
  end

  (* hierconn *) wire [WORDS*LINK-1:0] \dut.gathered ;
  (* hierconn *) wire [8:0] \dut.count ;
  wire [8:0] needed = (command_bits(sent[COMMAND_BITS-1:0]) + LINK - 1) / LINK;
  always @* begin
    assume (reset == !begun);
    assume (!take || whole);
    if (begun) begin
      assume (words == 0 || is_command(sent[5:0]) && command_bits(sent[COMMAND_BITS-1:0]) <= COMMAND_BITS);
      assert (\dut.count == words * LINK);
      assert (\dut.gathered == sent);
      assert (sent >> words * LINK == 0);
      assert (command == sent[COMMAND_BITS-1:0]);
      assert (words <= WORDS);
      assert (whole == (words != 0 && words >= needed));
      assert (words == 0 || words <= needed);
      assert (!take_word || word_valid && !drop && (!whole || take));
      assert (take_word || !word_valid || drop || whole && !take);
    end
  end
endmodule
