`include "faults.vh"

// The words that make memory and registers 0: so many clocks, over which the memory's bits are spread evenly
// (hw/pixel_planes/clear_step.h has in which of them a bit becomes 0).
module clearer #(
  parameter MEMORY_BITS = 72,
  parameter CLOCKS = 1,
  parameter ADDRESS = 7
) (
  input wire clk,
  input wire reset,
  input wire begins,
  input wire goes_on,
  output wire [ADDRESS-1:0] address,
  output wire [ADDRESS:0] count,
  output wire last
);
  localparam EACH = MEMORY_BITS / CLOCKS;
  localparam OVER = MEMORY_BITS % CLOCKS;
  localparam STEPS = $clog2(CLOCKS + 1) + 1;
  reg [STEPS-1:0] step;
  reg [STEPS-1:0] rest;  // of the bits times the clocks that have gone by, over CLOCKS
  reg [ADDRESS:0] done;

  wire [STEPS-1:0] this_step = begins ? 0 : step;
  wire [STEPS:0] this_rest = (begins ? 0 : rest) + OVER;
  wire carry = this_rest >= CLOCKS;
  wire [ADDRESS:0] from = begins ? 0 : done;
  wire [ADDRESS:0] bits = EACH + carry;
  assign last = this_step == CLOCKS - 1;
  assign address = from[ADDRESS-1:0];
  assign count = bits - (last & `FAULT(`FAULT_CLEAR));

  always @(posedge clk) begin
    if (reset) begin
      step <= 0;
      rest <= 0;
      done <= 0;
    end else if (begins | goes_on) begin
      step <= this_step + 1;
      rest <= carry ? this_rest - CLOCKS : this_rest;
      done <= from + bits;
    end
  end
endmodule
