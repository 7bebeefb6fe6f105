`include "faults.vh"

// The partial root, positioned for the next trial: after each trial it shifts down by one bit, and the new bit is
// inserted below, at the position of the trial's bit 0.
module found_root #(
  parameter BITS = 96,
  parameter PLACE = 7
) (
  input wire takes,
  input wire [PLACE-1:0] place,
  input wire root_bit,
  input wire [BITS-1:0] in,
  output wire [BITS-1:0] out
);
  wire [BITS-1:0] here = {{BITS - 1{1'b0}}, 1'b1} << place;
  assign out = takes ? (`CELL_FAULT(`FAULT_ROOT_STAYS) ? in : in >> 1) | (here & {BITS{root_bit}}) : in;
endmodule
