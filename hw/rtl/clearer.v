// Issues the words that clear memory and registers: CLOCKS words, over which the memory's bits are distributed evenly
// (hw/pixel_planes/clear_step.h: word k, from 0, clears the bits from k * MEMORY_BITS / CLOCKS up to, but not
// including, the first bit of the next word).
`include "faults.vh"

module clearer #(
  parameter MEMORY_BITS = 72,
  parameter CLOCKS = 1,        // at least 1
  parameter ADDRESS = 7
) (
  input wire clk,
  input wire reset,
  input wire begins,                // the first word is issued at this edge
  input wire goes_on,               // a further word is issued
  input wire [ADDRESS:0] limit,     // bits from this one on are not cleared
  output wire [ADDRESS-1:0] address,
  output wire [ADDRESS:0] count,
  output wire last
);
  localparam [31:0] EACH = MEMORY_BITS / CLOCKS;
  localparam [31:0] OVER = MEMORY_BITS % CLOCKS;
  localparam [31:0] WORDS = CLOCKS;
  localparam [31:0] END = CLOCKS - 1;
  localparam STEPS = $clog2(CLOCKS + 1) + 1;
  reg [STEPS-1:0] step;
  reg [STEPS-1:0] rest;  // remainder of bits times elapsed clocks divided by CLOCKS
  reg [ADDRESS:0] done;

  wire [STEPS-1:0] this_step = begins ? 0 : step;
  wire [STEPS-1:0] this_rest = (begins ? 0 : rest) + OVER[STEPS-1:0];
  wire carry = this_rest >= WORDS[STEPS-1:0];
  wire [ADDRESS:0] from = begins ? 0 : done;
  wire [ADDRESS:0] up_to = from + EACH[ADDRESS:0] + (carry ? 1 : 0);
  assign last = this_step == END[STEPS-1:0];

  /* verilator lint_off UNUSEDSIGNAL */
  wire [ADDRESS:0] from_here = from < limit ? from : limit;
  /* verilator lint_on UNUSEDSIGNAL */
  wire [ADDRESS:0] to_here = up_to < limit ? up_to : limit;
  assign address = from_here[ADDRESS-1:0];
  assign count = to_here - from_here - (last & `FAULT(`FAULT_CLEAR) ? 1 : 0);

  always @(posedge clk) begin
    if (reset) begin
      step <= 0;
      rest <= 0;
      done <= 0;
    end else if (begins | goes_on) begin
      step <= this_step + 1;
      rest <= carry ? this_rest - WORDS[STEPS-1:0] : this_rest;
      done <= up_to;
    end
  end
endmodule
