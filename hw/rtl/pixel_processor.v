// Pixels that execute the same control word: each has a bit-serial processor of ALU_BITS places with enable E, carry K,
// a latch for the first operand of a memory with one read port, and with ROOTS a flag G. Written from the meanings of
// the instruction table (hw/isa/opcodes.h), docs/machines/pixel-planes.md and thesis 7.2.1: "logical operations and
// comparisons of values can be performed in the ALU by a one-bit adder". Vectors have one bit per pixel; if they have
// several places of the ALU, the least significant place comes first.
`include "faults.vh"

module pixel_processor #(
  parameter PIXELS = 1,
  parameter MEMORY_READS = 1,  // with two, the latch is unused
  parameter ALU_BITS = 1,
  parameter ROOTS = 1,         // 0: no flag, and `root` is not supported
  parameter ADDRESS = 7,
  parameter SIDE = 5
) (
  input wire clk,
  input wire reset,
  /* verilator lint_off UNUSEDSIGNAL */
  input wire [CONTROL_BITS-1:0] control,
  /* verilator lint_on UNUSEDSIGNAL */
  input wire [PIXELS-1:0] in_region,              // pixels of the region in a clearing word
  input wire [PIXELS-1:0] tree,                   // bits of F
  input wire [PIXELS*ALU_BITS-1:0] memory_x,      // data of the read ports
  input wire [PIXELS*ALU_BITS-1:0] memory_y,
  output reg [PIXELS*ALU_BITS-1:0] written,
  output wire [PIXELS-1:0] may_write,
  output reg [PIXELS-1:0] enable
);
`include "control_word.vh"
  localparam ALL = {PIXELS{1'b1}};

  reg [PIXELS-1:0] carry;
  reg [PIXELS*ALU_BITS-1:0] latch;
  wire [PIXELS-1:0] flag;

  wire [1:0] x_select = control[CW_X_SELECT +: 2];
  wire [1:0] carry_in = control[CW_CARRY_IN +: 2];
  wire clear = control[CW_CLEAR];
  reg [PIXELS-1:0] present;  // pixel is part of the segment

  wire [PIXELS-1:0] first_carry = carry_in == CARRY_KEPT ? carry & ~{PIXELS{`FAULT(`FAULT_CARRY)}}
                                                         : {PIXELS{carry_in == CARRY_ONE}};
  wire [PIXELS-1:0] result;
  wire [PIXELS-1:0] turned;  // operand x is inverted, because a root subtracts there
  generate
    if (ROOTS != 0) begin : roots
      reg [PIXELS-1:0] negative;
      always @(posedge clk) begin
        if (reset | clear) negative <= {PIXELS{1'b0}};
        else if (control[CW_SET_FLAG]) negative <= ~result;
      end
      assign flag = negative;
      assign turned = {PIXELS{control[CW_X_BY_FLAG]}} & (`FAULT(`FAULT_FLAG) ? ALL : ~flag);
    end else begin : no_roots
      assign flag = {PIXELS{1'b0}};
      assign turned = flag;
    end
  endgenerate
  reg [PIXELS*ALU_BITS-1:0] x;
  reg [PIXELS-1:0] y, p, q, carry_here, sum, carry_out, last_carry, all_ones;
  integer i;
  always @* begin
    case (x_select)
      X_TREE: x = {ALU_BITS{tree}};
      X_LATCH: x = latch;
      X_MEMORY: x = memory_x;
      default: x = {ALU_BITS{enable}};
    endcase
    last_carry = first_carry;
    all_ones = ALL;
    for (i = 0; i < ALU_BITS; i = i + 1) begin
      y = control[CW_Y_ENABLE] ? enable : memory_y[i*PIXELS +: PIXELS];
      p = control[CW_X_ZERO + i] ? {PIXELS{1'b0}} : x[i*PIXELS +: PIXELS];
      p = p ^ {PIXELS{control[CW_X_INVERT + i]}} ^ turned;
      q = control[CW_Y_ZERO] ? {PIXELS{1'b0}} : y;
      q = q ^ {PIXELS{control[CW_Y_INVERT]}};
      carry_here = control[CW_RIPPLE] ? last_carry : first_carry;
      sum = p ^ q ^ (`FAULT(`FAULT_ALU_FUNCTION) ? {PIXELS{1'b0}} : carry_here);
      carry_out = (p & q) | (p & carry_here) | (q & carry_here);
      if (control[CW_ACTIVE + i]) begin
        last_carry = carry_out;
        all_ones = all_ones & sum;
      end
      written[i*PIXELS +: PIXELS] = control[CW_SUM] ? sum : carry_out;
    end
  end

  assign result = (control[CW_SUM] ? all_ones : last_carry) ^ {PIXELS{control[CW_INVERT]}};
  assign may_write = control[CW_WRITE_ALL] ? ALL : control[CW_WRITE_SELECTED] ? enable & carry : enable;
  wire [PIXELS-1:0] held_back = control[CW_AND_ENABLE] & ~`FAULT(`FAULT_ENABLE) ? enable : ALL;
  wire [PIXELS-1:0] may_latch = `FAULT(`FAULT_SECOND_READ) ? enable : ALL;

  integer j;
  always @(posedge clk) begin
    if (reset | clear) begin
      enable <= {PIXELS{1'b0}};
      carry <= {PIXELS{1'b0}};
      latch <= {(PIXELS*ALU_BITS){1'b0}};
      present <= in_region & {PIXELS{~reset}};
    end else begin
      if (control[CW_SET_ENABLE]) enable <= present & result & held_back;
      if (control[CW_SET_CARRY]) carry <= control[CW_SELECT] ? enable & result : last_carry;
      for (j = 0; j < ALU_BITS; j = j + 1)
        if (MEMORY_READS == 1 & control[CW_LATCH] & control[CW_ACTIVE + j])
          latch[j*PIXELS +: PIXELS] <= (x[j*PIXELS +: PIXELS] & may_latch) | (latch[j*PIXELS +: PIXELS] & ~may_latch);
    end
  end
endmodule
