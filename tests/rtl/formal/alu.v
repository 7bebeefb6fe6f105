// A step of a pixel's processor follows its truth table for any control word, registers, memory and tree bits: the
// table below gives the sum and the carry of each place from p, q and carry, thesis 7.2.1. E, K, G, the latch and the
// memory writes follow the description of each bit in hw/rtl/control_word.vh. There are no assumptions.
module alu_check #(
  parameter ALU_BITS = 1,
  parameter MEMORY_READS = 1,
  parameter ADDRESS = 2,
  parameter SIDE = 2
) (
  input wire clk,
  input wire reset,
  input wire [CONTROL_BITS-1:0] control,
  input wire in_region,
  input wire tree,
  input wire [ALU_BITS-1:0] memory_x,
  input wire [ALU_BITS-1:0] memory_y
);
`include "control_word.vh"
  wire [ALU_BITS-1:0] written;
  wire may_write, enable;
  pixel_processor #(.ALU_BITS(ALU_BITS), .MEMORY_READS(MEMORY_READS), .ROOTS(1), .ADDRESS(ADDRESS), .SIDE(SIDE)) dut (
    .clk(clk), .reset(reset), .control(control), .in_region(in_region), .tree(tree), .memory_x(memory_x),
    .memory_y(memory_y), .written(written), .may_write(may_write), .enable(enable));
  (* hierconn *) wire [ALU_BITS-1:0] \dut.latch ;
  (* hierconn *) wire \dut.carry ;
  (* hierconn *) wire \dut.flag ;
  wire [ALU_BITS-1:0] latch = \dut.latch ;
  wire carry = \dut.carry ;
  wire flag = \dut.flag ;
  (* hierconn *) wire \dut.present ;

  // {carry out, sum} of p, q and carry: 0 to 3 ones.
  function [1:0] table_of(input [2:0] ones);
    case (ones)
      3'b000: table_of = 2'b00;
      3'b001, 3'b010, 3'b100: table_of = 2'b01;
      3'b011, 3'b101, 3'b110: table_of = 2'b10;
      3'b111: table_of = 2'b11;
    endcase
  endfunction

  wire [1:0] x_select = control[CW_X_SELECT +: 2];
  wire [1:0] carry_in = control[CW_CARRY_IN +: 2];
  wire subtracts = control[CW_X_BY_FLAG] && !flag;
  wire begins = carry_in == CARRY_KEPT ? carry : carry_in == CARRY_ONE;
  reg [ALU_BITS-1:0] x, sums, carries;
  reg x_bit, y_bit, p, q, running, all_ones;
  integer i;
  always @* begin
    running = begins;
    all_ones = 1'b1;
    for (i = 0; i < ALU_BITS; i = i + 1) begin
      case (x_select)
        X_TREE: x_bit = tree;
        X_LATCH: x_bit = latch[i];
        X_MEMORY: x_bit = memory_x[i];
        X_ENABLE: x_bit = enable;
      endcase
      x[i] = x_bit;
      y_bit = control[CW_Y_ENABLE] ? enable : memory_y[i];
      p = (control[CW_X_ZERO + i] ? 1'b0 : x_bit) != (control[CW_X_INVERT + i] != subtracts);
      q = (control[CW_Y_ZERO] ? 1'b0 : y_bit) != control[CW_Y_INVERT];
      {carries[i], sums[i]} = table_of({p, q, control[CW_RIPPLE] ? running : begins});
      if (control[CW_ACTIVE + i]) begin
        running = carries[i];
        all_ones = all_ones && sums[i];
      end
    end
  end
  wire result = (control[CW_SUM] ? all_ones : running) != control[CW_INVERT];

  reg begun = 1'b0;
  reg next_enable, next_carry, next_flag, next_present;
  reg [ALU_BITS-1:0] next_latch;
  integer j;
  always @(posedge clk) begin
    begun <= 1'b1;
    next_enable <= control[CW_SET_ENABLE] ? \dut.present && result && (!control[CW_AND_ENABLE] || enable) : enable;
    next_carry <= !control[CW_SET_CARRY] ? carry : control[CW_SELECT] ? enable && result : running;
    next_flag <= control[CW_SET_FLAG] ? !result : flag;
    next_present <= \dut.present ;
    for (j = 0; j < ALU_BITS; j = j + 1)
      next_latch[j] <= MEMORY_READS == 1 && control[CW_LATCH] && control[CW_ACTIVE + j] ? x[j] : latch[j];
    if (reset || control[CW_CLEAR]) begin
      {next_enable, next_carry, next_flag} <= 3'b000;
      next_latch <= 0;
      next_present <= in_region && !reset;
    end
    if (begun) begin
      assert (enable == next_enable);
      assert (carry == next_carry);
      assert (flag == next_flag);
      assert (latch == next_latch);
      assert (\dut.present == next_present);
    end
    assert (written == (control[CW_SUM] ? sums : carries));
    assert (may_write == (control[CW_WRITE_ALL] || (control[CW_WRITE_SELECTED] ? enable && carry : enable)));
  end
endmodule
