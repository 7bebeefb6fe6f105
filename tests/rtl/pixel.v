// Pixels that obey the same control word and share their word lines: a bit-serial processor with enable, carry and latch,
// and its memory, at each; with CSGSIM_ROOTS a flag for roots too. Written from the meanings of the instruction table
// (hw/isa/opcodes.h), docs/machines/pixel-planes-4.md
// and thesis 7.2.1. Vectors have a bit a pixel; where they have several places of the ALU, the least significant first.
`include "faults.vh"

// ALU and registers.
module pixel_processor #(
  parameter PIXELS = 1,
  parameter MEMORY_READS = 1,  // with two nothing is ever latched
  parameter ALU_BITS = 1,
  parameter ADDRESS = 7,
  parameter SIDE = 5
) (
  input wire clk,
  input wire reset,
  input wire [3:0] fault,
  input wire [CONTROL_BITS-1:0] control,
  input wire [PIXELS-1:0] in_region,              // of a word that clears
  input wire [PIXELS-1:0] tree,                   // bits of F
  input wire [PIXELS*ALU_BITS-1:0] memory_x,      // what the read ports deliver
  input wire [PIXELS*ALU_BITS-1:0] memory_y,
  output reg [PIXELS*ALU_BITS-1:0] written,
  output wire [PIXELS-1:0] may_write,
  output reg [PIXELS-1:0] enable,
  output reg [PIXELS-1:0] carry,
  output wire [PIXELS-1:0] flag,
  output reg [PIXELS*ALU_BITS-1:0] latch
);
`include "control_word.vh"
  localparam ALL = {PIXELS{1'b1}};

  wire [1:0] x_select = control[CW_X_SELECT +: 2];
  wire [1:0] carry_in = control[CW_CARRY_IN +: 2];
  wire clear = control[CW_CLEAR];
  reg [PIXELS-1:0] present;  // part of the segment

  wire [PIXELS-1:0] first_carry = carry_in == CARRY_KEPT ? carry & ~{PIXELS{`FAULT(`FAULT_CARRY)}}
                                                         : {PIXELS{carry_in == CARRY_ONE}};
  wire [PIXELS-1:0] result;
`ifdef CSGSIM_ROOTS
  reg [PIXELS-1:0] negative;
  always @(posedge clk) begin
    if (reset | clear) negative <= {PIXELS{1'b0}};
    else if (control[CW_SET_FLAG]) negative <= ~result;
  end
  assign flag = negative;
  // Operand x is inverted where a root subtracts.
  wire [PIXELS-1:0] turned = {PIXELS{control[CW_X_BY_FLAG]}} & (`FAULT(`FAULT_FLAG) ? ALL : ~negative);
`define TURNED ^ turned
`else
  assign flag = {PIXELS{1'b0}};
`define TURNED
`endif
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
      p = p ^ {PIXELS{control[CW_X_INVERT + i]}} `TURNED;
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

// Memory with one or two ports to read, and one to write. A port has ALU_BITS adjacent bits, of which those beyond the
// memory's end read as 0. `clear_line` is 1 for the bits that become 0 at every pixel.
module pixel_memory #(
  parameter PIXELS = 1,
  parameter MEMORY_BITS = 72,
  parameter ALU_BITS = 1,
  parameter ADDRESS = 7
) (
  input wire clk,
  input wire reset,
  input wire [3:0] fault,
  input wire [ADDRESS-1:0] address_x,
  input wire [ADDRESS-1:0] address_y,
  input wire [ADDRESS-1:0] address_w,
  input wire [MEMORY_BITS-1:0] clear_line,
  input wire [PIXELS*ALU_BITS-1:0] written,
  input wire [ALU_BITS-1:0] write,              // those places
  input wire [PIXELS-1:0] may_write,            // at those pixels
  output reg [PIXELS*ALU_BITS-1:0] read_x,
  output reg [PIXELS*ALU_BITS-1:0] read_y,
  output reg [PIXELS*MEMORY_BITS-1:0] memory    // bit 0 of every pixel first
);
  localparam [ADDRESS:0] END = MEMORY_BITS;
  wire [ADDRESS:0] from_x = {1'b0, address_x};
  wire [ADDRESS:0] from_y = {1'b0, address_y};
  wire [ADDRESS:0] from_w = {1'b0, address_w};
  wire [ADDRESS:0] end_w = `FAULT(`FAULT_MEMORY_WRITE) ? END - 1 : END;

  integer i;
  always @* begin
    for (i = 0; i < ALU_BITS; i = i + 1) begin
      read_x[i*PIXELS +: PIXELS] = from_x + i < END ? memory[(from_x + i)*PIXELS +: PIXELS] : {PIXELS{1'b0}};
      read_y[i*PIXELS +: PIXELS] = from_y + i < END ? memory[(from_y + i)*PIXELS +: PIXELS] : {PIXELS{1'b0}};
    end
  end

  integer j;
  always @(posedge clk) begin
    if (reset | |clear_line) begin
      for (j = 0; j < MEMORY_BITS; j = j + 1)
        if (reset | clear_line[j]) memory[j*PIXELS +: PIXELS] <= {PIXELS{1'b0}};
    end else begin
      for (j = 0; j < ALU_BITS; j = j + 1)
        if (write[j] && from_w + j < end_w)
          memory[(from_w + j)*PIXELS +: PIXELS] <= (memory[(from_w + j)*PIXELS +: PIXELS] & ~may_write) |
                                                   (written[j*PIXELS +: PIXELS] & may_write);
    end
  end
endmodule

module pixels #(
  parameter PIXELS = 64,
  parameter MEMORY_BITS = 72,
  parameter MEMORY_READS = 1,
  parameter ALU_BITS = 1,
  parameter ADDRESS = 7,
  parameter SIDE = 5
) (
  input wire clk,
  input wire reset,
  input wire [3:0] fault,
  input wire [CONTROL_BITS-1:0] control,
  input wire [MEMORY_BITS-1:0] clear_line,
  input wire [PIXELS-1:0] in_region,
  input wire [PIXELS-1:0] tree,
  output wire [PIXELS-1:0] enable,
  output wire [PIXELS-1:0] carry,
  output wire [PIXELS-1:0] flag,
  output wire [PIXELS*ALU_BITS-1:0] latch,
  output wire [PIXELS*MEMORY_BITS-1:0] memory
);
`include "control_word.vh"

  wire [PIXELS*ALU_BITS-1:0] read_x;
  wire [PIXELS*ALU_BITS-1:0] read_y;
  wire [PIXELS*ALU_BITS-1:0] written;
  wire [PIXELS-1:0] may_write;
  wire [ALU_BITS-1:0] write = control[CW_ACTIVE +: ALU_BITS] & {ALU_BITS{control[CW_WRITE]}};

  pixel_processor #(
    .PIXELS(PIXELS), .MEMORY_READS(MEMORY_READS), .ALU_BITS(ALU_BITS), .ADDRESS(ADDRESS), .SIDE(SIDE)
  ) processors (
    .clk(clk), .reset(reset), .fault(fault), .control(control), .in_region(in_region), .tree(tree),
    .memory_x(read_x), .memory_y(MEMORY_READS == 1 | `FAULT(`FAULT_SECOND_READ) ? read_x : read_y),
    .written(written), .may_write(may_write), .enable(enable), .carry(carry), .flag(flag),
    .latch(latch));

  pixel_memory #(.PIXELS(PIXELS), .MEMORY_BITS(MEMORY_BITS), .ALU_BITS(ALU_BITS), .ADDRESS(ADDRESS)) memories (
    .clk(clk), .reset(reset), .fault(fault), .address_x(control[CW_X +: ADDRESS]), .address_y(control[CW_Y +: ADDRESS]),
    .address_w(control[CW_W +: ADDRESS]), .clear_line(clear_line), .written(written), .write(write),
    .may_write(may_write), .read_x(read_x), .read_y(read_y), .memory(memory));
endmodule
