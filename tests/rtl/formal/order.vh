// A place in an instruction, (turn, bit, read of it) or for streams (pass, bit), as a number that grows towards its
// end. `bits` is the number of bits at such a place.
function is_stream(input [5:0] number);
  is_stream = number >= EDGE_NOT_NEGATIVE && number <= KEEP_MIN || number == STRIPE || number == LINEAR_PLUS ||
              number == LINEAR_MINUS;
endfunction
function is_one_step(input [5:0] number);
  is_one_step = number <= ENABLE_STORE || number == GLOBAL_OR || number == SKIP_IF_NONE || number == SQUARES;
endfunction
function [5:0] bits_of(input [41:0] command, input [5:0] turn);
  case (command[5:0])
    EDGE_NOT_NEGATIVE, EDGE_NEGATIVE, STRIPE: bits_of = command[FIELD_0 +: 6];
    ROOT: bits_of = turn + 6'd3;
    default: bits_of = is_stream(command[5:0]) ? command[FIELD_1 +: 6] : command[FIELD_0 + BASE_BITS +: 6];
  endcase
endfunction
// Validity by docs/instruction-set.md: fields have at least one bit, and for a root an odd number of at least 3.
function is_valid(input [41:0] command);
  is_valid = command[5:0] <= ROOT && (is_one_step(command[5:0]) || bits_of(command, 6'd0) != 0) &&
             (command[5:0] != ROOT || command[FIELD_0 + BASE_BITS] && command[FIELD_0 + BASE_BITS +: 6] >= 3);
endfunction
function is_place(input [41:0] command, input [5:0] turn, input [5:0] at);
  is_place = at < bits_of(command, turn) &&
             (command[5:0] == ROOT ? turn < command[FIELD_0 + BASE_BITS +: 6] >> 1 : turn == 0);
endfunction
function [12:0] order_of(input [5:0] number, input [5:0] turn, input [5:0] at, input pass);
  order_of = is_stream(number) ? {6'd0, pass, at} : {turn, at, pass};
endfunction
