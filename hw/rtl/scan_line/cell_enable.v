`include "faults.vh"

// E of a cell, and the write enable of an instruction's result.
module cell_enable (
  input wire clk,
  input wire reset,
  input wire fresh,        // E reads as 0 in this clock
  input wire disables,     // E becomes 0 in the next clock
  input wire act,          // clock of an instruction's result
  input wire [5:0] opcode,
  input wire single,       // the bit that was read
  input wire sign,         // sign of F
  input wire less,         // comparison results of the ALU
  input wire below,
  input wire equal,
  input wire fits,
  output wire enabled,     // E in this clock
  output wire writes,      // the result is written in this clock
  output reg enable
);
`include "opcodes.vh"
  assign enabled = enable && !fresh;

  wire keeps = opcode == KEEP_MAX ? !less && !equal : less || (equal && `CELL_FAULT(`FAULT_KEEP_MIN));
  reg next;
  always @*
    case (opcode)
      ENABLE_ALL: next = 1'b1;
      ENABLE_INVERT: next = !enabled;
      ENABLE_LOAD: next = single;
      ENABLE_AND: next = enabled && single;
      ENABLE_AND_NOT: next = (enabled || `CELL_FAULT(`FAULT_ENABLE)) && !single;
      ENABLE_OR: next = enabled || single;
      ENABLE_XOR: next = enabled != single;
      EDGE_NOT_NEGATIVE: next = enabled && !sign;
      EDGE_NEGATIVE, STRIPE: next = enabled && sign;
      LINEAR_GE: next = enabled && !less;
      LINEAR_GT: next = enabled && !less && !equal;
      LINEAR_LE: next = enabled && (less || equal);
      LINEAR_LT: next = enabled && less;
      LINEAR_EQ, FIELD_EQ: next = enabled && equal;
      LOAD_LINEAR: next = enabled && fits;
      KEEP_MAX, KEEP_MIN: next = enabled && (fits || !keeps);
      FIELD_LT: next = enabled && below;
      FIELD_LE: next = enabled && (below || equal);
      default: next = enabled;
    endcase

  wire result_writes = opcode == ENABLE_STORE || (enabled && ((opcode != KEEP_MAX && opcode != KEEP_MIN) || keeps));
  reg written;
  assign writes = act ? result_writes : written || `CELL_FAULT(`FAULT_WRITES);

  always @(posedge clk)
    if (reset) {enable, written} <= 2'b0;
    else begin
      enable <= disables ? 1'b0 : act ? next : enabled;
      written <= writes;
    end
endmodule
