`include "faults.vh"

// The ALU of a cell: processes the next `count` bits of two operands, starting at bit `low` of two groups of LANES
// bits, and combines the results with those of earlier bits. The results are kept while the ALU is idle.
module cell_alu #(
  parameter LANES = 32,
  parameter ROOTS = 0,
  parameter LANE = 5,
  parameter COUNT = 6
) (
  input wire clk,
  input wire reset,
  input wire work,
  input wire begins,                 // first bits of the operands
  input wire [2:0] operation,
  input wire [LANE-1:0] low,
  input wire [COUNT-1:0] count,
  input wire [COUNT-1:0] meeting,    // number of the `count` bits that are within the field
  /* verilator lint_off UNUSEDSIGNAL */
  input wire try,                    // a root trial: x is the remainder, y the partial root
  input wire try_first,              // the bits include bit 0 of the trial
  input wire try_second,             // the bits include bit 1
  input wire try_last,               // the bits include the sign
  /* verilator lint_on UNUSEDSIGNAL */
  input wire [2*LANES-1:0] x,
  input wire [2*LANES-1:0] y,
  output wire [2*LANES-1:0] taken,   // mask of the processed bits
  output wire [2*LANES-1:0] value,   // value of these bits
  output wire root_bit,              // valid at try_last
  // Comparison x - y, including the bits of this clock:
  output wire less,                  // signed, for nonnegative y
  output wire below,                 // unsigned
  output wire equal,
  output wire fits                   // x fits the field
);
  localparam ALU_ADD = 3'd1, ALU_SUBTRACT = 3'd2, ALU_AND = 3'd3, ALU_OR = 3'd4, ALU_XOR = 3'd5, ALU_AND_NOT = 3'd6,
    ALU_NOT = 3'd7;
  localparam [2*LANES-1:0] ALL = {2 * LANES{1'b1}};
  localparam [2*LANES-1:0] ONE = {{2 * LANES - 1{1'b0}}, 1'b1};

  wire [LANE-1:0] from = `CELL_FAULT(`FAULT_ALU_BEGIN) && low != 0 ? low - 1'b1 : low;
  assign taken = ~(ALL << count) << from;
  wire [2*LANES-1:0] beyond_field = taken & (ALL << meeting << from);
  wire [2*LANES-1:0] lowest = ONE << from;
  wire [2*LANES-1:0] top = taken & ~(taken >> 1);

  wire subtracts_root;
  wire inverts = try ? subtracts_root : operation == ALU_SUBTRACT;
  wire [2*LANES-1:0] bit_0 = try && try_first ? lowest : {2 * LANES{1'b0}};
  wire [2*LANES-1:0] bit_1 = !try || !try_second ? {2 * LANES{1'b0}} : try_first ? lowest << 1 : lowest;
  wire [2*LANES-1:0] operand = (y ^ {2 * LANES{inverts}} ^ bit_0) | bit_1;
  reg carry;
  wire kept = carry && !`CELL_FAULT(`FAULT_ALU_CARRY);
  wire carry_in = (try ? try_first : begins) ? inverts : kept;
  wire [2*LANES:0] sum =
    {1'b0, x & taken} + {1'b0, operand & taken} + (carry_in ? {1'b0, lowest} : {2 * LANES + 1{1'b0}});
  wire carry_out = |(sum & ~{1'b0, taken});

  reg [2*LANES-1:0] result;
  always @*
    if (try) result = sum[0 +: 2*LANES] ^ (try_last ? top : {2 * LANES{1'b0}});
    else case (operation)
      ALU_ADD, ALU_SUBTRACT: result = sum[0 +: 2*LANES];
      ALU_AND: result = x & y;
      ALU_OR: result = x | y;
      ALU_XOR: result = x ^ y;
      ALU_AND_NOT: result = `CELL_FAULT(`FAULT_AND_NOT) ? x & y : x & ~y;
      ALU_NOT: result = ~x;
      default: result = {2 * LANES{1'b0}};
    endcase
  assign value = result & taken;
  assign root_bit = |(value & top);

  reg differs;
  reg beyond;
  reg negative;
  reg negative_x;
  wire differs_now = work ? (differs && !begins && !`CELL_FAULT(`FAULT_ALU_DIFFERS)) || |value : differs;
  wire beyond_now = work ? (beyond && !begins) || (|(x & beyond_field) && !`CELL_FAULT(`FAULT_ALU_BEYOND)) : beyond;
  wire negative_now = work ? |(value & top) : negative;
  wire negative_x_now = work ? |(x & top) : negative_x;
  wire carry_now = work || try ? carry_out : carry;
  assign less = negative_x_now || negative_now;
  assign below = !carry_now;
  assign equal = !differs_now;
  assign fits = !negative_x_now && !beyond_now;

  always @(posedge clk)
    if (reset) {carry, differs, beyond, negative, negative_x} <= 5'b0;
    else {carry, differs, beyond, negative, negative_x} <= {carry_now, differs_now, beyond_now, negative_now, negative_x_now};

  generate
    if (ROOTS == 0) begin : no_roots
      assign subtracts_root = 1'b0;
    end else begin : roots
      reg remainder_negative;
      assign subtracts_root = begins || !remainder_negative || `CELL_FAULT(`FAULT_ROOT_SIGN);
      always @(posedge clk)
        if (reset) remainder_negative <= 1'b0;
        else if (try && try_last) remainder_negative <= !root_bit;
        else if (try && begins) remainder_negative <= 1'b0;
    end
  endgenerate
endmodule
