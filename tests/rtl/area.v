// What area.py has synthesised: a pixel without its memory, and what the machine has of controllers.

// A pixel's memory of ALU_BITS columns of cells, of which bit a is in column a mod ALU_BITS: so that adjacent bits are on
// different bit lines. A port turns its columns so that place 0 of the ALU meets the bit addressed.
module rotator #(
  parameter ALU_BITS = 1,
  parameter TURN = 1
) (
  input wire [TURN-1:0] turn,
  input wire [ALU_BITS-1:0] in,
  output wire [ALU_BITS-1:0] out
);
  wire [2*ALU_BITS-1:0] twice = {in, in} >> turn;
  assign out = twice[ALU_BITS-1:0];
endmodule

module area_pixel #(
  parameter MEMORY_READS = 1,
  parameter ALU_BITS = 1,
  parameter ROOTS = 0,
  parameter ADDRESS = 7,
  parameter SIDE = 10,
  parameter TURN = ALU_BITS > 1 ? $clog2(ALU_BITS) : 1
) (
  input wire clk,
  input wire [CONTROL_BITS-1:0] control,
  input wire in_region,
  input wire tree,
  input wire [ALU_BITS-1:0] columns_x,
  input wire [ALU_BITS-1:0] columns_y,
  output wire [ALU_BITS-1:0] columns_w,
  output wire may_write,
  output wire enable
);
`include "control_word.vh"
  localparam LOW = ALU_BITS > 1 ? $clog2(ALU_BITS) : 0;
  wire [ALU_BITS-1:0] memory_x;
  wire [ALU_BITS-1:0] memory_y;
  wire [ALU_BITS-1:0] written;
  // The turns are addresses modulo ALU_BITS, a power of two; that of the write port is the other way round.
  wire [TURN-1:0] turn_x = LOW > 0 ? control[CW_X +: TURN] : 1'b0;
  wire [TURN-1:0] turn_y = LOW > 0 ? control[CW_Y +: TURN] : 1'b0;
  wire [TURN-1:0] turn_w = LOW > 0 ? control[CW_W +: TURN] : 1'b0;

  rotator #(.ALU_BITS(ALU_BITS), .TURN(TURN)) port_x (.turn(turn_x), .in(columns_x), .out(memory_x));
  generate
    if (MEMORY_READS == 1) begin : one_port
      assign memory_y = memory_x;
    end else begin : two_ports
      rotator #(.ALU_BITS(ALU_BITS), .TURN(TURN)) port_y (.turn(turn_y), .in(columns_y), .out(memory_y));
    end
  endgenerate
  rotator #(.ALU_BITS(ALU_BITS), .TURN(TURN)) port_w (.turn(turn_w), .in(written), .out(columns_w));

  pixel_processor #(.MEMORY_READS(MEMORY_READS), .ALU_BITS(ALU_BITS), .ROOTS(ROOTS), .ADDRESS(ADDRESS), .SIDE(SIDE)) processor (
    .clk(clk), .reset(1'b0), .control(control), .in_region(in_region), .tree(tree),
    .memory_x(memory_x), .memory_y(memory_y), .written(written), .may_write(may_write), .enable(enable));
endmodule

module area_node (
  input wire clk,
  input wire first,
  input wire multiplicand,
  input wire in,
  output wire left,
  output wire right
);
  tree_node node (
    .clk(clk), .reset(1'b0), .first(first), .multiplicand(multiplicand), .in(in), .left(left),
    .right(right));
endmodule

// A node of the Y trees of degree 2, as docs/machines/pixel-powers.md has it: its value and its slope, each passed on to
// one child a clock later, and to the other with what h rows on make of them. The slope times h comes from DELAY
// registers of the node's own, log2 h: none in half of the nodes, one in a quarter, two in an eighth, so one in the mean.
// The wires with h * h and 2h times the square's coefficient are those of a level.
module area_node_2 #(
  parameter DELAY = 1
) (
  input wire clk,
  input wire first,
  input wire counts,        // the delayed slope is of this stream, not of the one before
  input wire square,        // h * h * C
  input wire square_slope,  // 2 * h * C
  input wire value,
  input wire slope,
  output reg left_value,
  output reg left_slope,
  output reg right_value,
  output reg right_slope
);
  wire late;
  delay #(.LENGTH(DELAY), .BITS(1)) times_h (.clk(clk), .reset(1'b0), .in(slope), .out(late));
  reg step_carry, value_carry, slope_carry;
  wire times = late & counts;
  wire step_kept = step_carry & ~first;
  wire value_kept = value_carry & ~first;
  wire slope_kept = slope_carry & ~first;
  wire step = times ^ square ^ step_kept;
  always @(posedge clk) begin
    left_value <= value;
    left_slope <= slope;
    right_value <= value ^ step ^ value_kept;
    right_slope <= slope ^ square_slope ^ slope_kept;
    step_carry <= (times & square) | (times & step_kept) | (square & step_kept);
    value_carry <= (value & step) | (value & value_kept) | (step & value_kept);
    slope_carry <= (slope & square_slope) | (slope & slope_kept) | (square_slope & slope_kept);
  end
endmodule

module area_delay #(
  parameter ALU_BITS = 1,
  parameter ADDRESS = 7,
  parameter SIDE = 10,
  parameter LATENCY = 18
) (
  input wire clk,
  input wire [CONTROL_BITS-1:0] in,
  output wire [CONTROL_BITS-1:0] out
);
`include "control_word.vh"
  delay #(.LENGTH(LATENCY), .BITS(CONTROL_BITS)) line (.clk(clk), .reset(1'b0), .in(in), .out(out));
endmodule
