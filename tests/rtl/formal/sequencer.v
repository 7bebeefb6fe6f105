// Every instruction ends: in each clock it is over, or (turn, bit, read) comes nearer to its end in a finite order. For
// streams the order is of passes, then bits; for roots of turns, bits, reads; else of bits, then reads. So it is issued for
// no more clocks than there are such steps. Assumed: a command of the table with fields and expressions of one bit or more,
// roots of an odd field of 3 bits or more, and a place in it that such an instruction comes by.
module sequencer_check #(
  parameter ALU_BITS = 1,
  parameter MEMORY_READS = 1,
  parameter ADDRESS = 7,
  parameter SIDE = 5
) (
  input wire [COMMAND_BITS-1:0] command,
  input wire [5:0] at,
  input wire pass,
  input wire [5:0] turn
);
`include "command.vh"
  wire last, next_pass;
  wire [5:0] next_at, next_turn;
  sequencer #(.ALU_BITS(ALU_BITS), .MEMORY_READS(MEMORY_READS), .ADDRESS(ADDRESS), .SIDE(SIDE)) dut (
    .command(command), .at(at), .pass(pass), .turn(turn), .control(), .first(), .a(), .b(), .c(), .next_at(next_at),
    .next_pass(next_pass), .next_turn(next_turn), .last(last));

  wire [5:0] number = command[5:0];
  wire has_no_field = number == EDGE_NOT_NEGATIVE || number == EDGE_NEGATIVE || number == STRIPE;
  wire stream = has_no_field || number >= LINEAR_GE && number <= KEEP_MIN || number == LINEAR_PLUS || number == LINEAR_MINUS;
  wire [5:0] field = command[FIELD_0 + BASE_BITS +: 6];
  wire [5:0] expression = has_no_field ? command[FIELD_0 +: 6] : command[FIELD_1 +: 6];
  wire is_root = number == ROOT;
  wire [5:0] bits = stream ? expression : is_root ? turn + 6'd3 : field;

  wire is_in_turn = is_root ? turn < field >> 1 && at < bits : turn == 0 && at < bits;
  wire [12:0] here = stream ? {6'd0, pass, at} : {turn, at, pass};
  wire [12:0] next = stream ? {6'd0, next_pass, next_at} : {next_turn, next_at, next_pass};
  wire is_command = number <= ROOT && number != 6'd33;
  wire one_step = number <= ENABLE_STORE || number == GLOBAL_OR || number == SKIP_IF_NONE;
  wire is_valid = is_command && bits != 0 && (!is_root || field[0] && field >= 3) && is_in_turn;
  wire [5:0] next_bits = stream ? expression : is_root ? next_turn + 6'd3 : field;
  always @* begin
    assert (!is_command || !one_step || last);
    if (is_valid && !one_step && !last) begin
      assert (next > here);
      assert (next_at < next_bits && (is_root ? next_turn < field >> 1 : next_turn == 0));
    end
  end
endmodule
