// Every instruction ends: in each clock it is over, or its place (order.vh) comes closer to its end in a finite order.
// So it is issued for no more clocks than it has places. Assumption: the command and the place in it are valid.
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
`include "order.vh"
  wire last, next_pass;
  wire [5:0] next_at, next_turn;
  sequencer #(.ALU_BITS(ALU_BITS), .MEMORY_READS(MEMORY_READS), .ADDRESS(ADDRESS), .SIDE(SIDE)) dut (
    .command(command), .squares({SQUARES_BITS{1'b0}}), .at(at), .pass(pass), .turn(turn), .next_at(next_at),
    .next_pass(next_pass), .next_turn(next_turn), .last(last));

  wire [5:0] number = command[5:0];
  always @* begin
    if (is_valid(command[41:0])) begin
      assert (!is_one_step(number) || last);
      if (!is_one_step(number) && is_place(command[41:0], turn, at) && !last) begin
        assert (order_of(number, next_turn, next_at, next_pass) > order_of(number, turn, at, pass));
        assert (is_place(command[41:0], next_turn, next_at));
      end
    end
  end
endmodule
