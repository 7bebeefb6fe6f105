// Synthesised by area.py: a pixel without its memory, and the logic shared by the whole machine.

// The rotator of a pixel's memory, which has ALU_BITS columns of cells with bit a in column a mod ALU_BITS, so that
// adjacent bits are on different bit lines. A port rotates its columns so that place 0 of the ALU gets the bit
// addressed.
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
  // The rotations are addresses modulo ALU_BITS, a power of two; the write port rotates in the opposite direction.
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

module area_node_2 #(
  parameter DELAY = 1
) (
  input wire clk,
  input wire first,
  input wire counts,
  input wire square,
  input wire square_slope,
  input wire value,
  input wire slope,
  output wire left_value,
  output wire left_slope,
  output wire right_value,
  output wire right_slope
);
  square_node #(.DELAY(DELAY)) node (
    .clk(clk), .reset(1'b0), .first(first), .counts(counts), .square(square), .square_slope(square_slope), .value(value),
    .slope(slope), .left_value(left_value), .left_slope(left_slope), .right_value(right_value), .right_slope(right_slope));
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
