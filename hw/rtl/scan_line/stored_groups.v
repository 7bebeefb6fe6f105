`include "faults.vh"

// Inserts bits into a group of a vector and into the next group.
module stored_groups #(
  parameter LANES = 32,
  parameter GROUP = 2,
  parameter BITS = 96
) (
  input wire store,
  input wire [GROUP-1:0] group,
  input wire [2*LANES-1:0] mask,
  input wire [2*LANES-1:0] value,
  input wire [BITS-1:0] in,
  output wire [BITS-1:0] out
);
  localparam COUNT = (BITS + LANES - 1) / LANES;
  wire [COUNT*LANES:0] padded = {{COUNT * LANES - BITS + 1{1'b0}}, in};
  /* verilator lint_off UNUSEDSIGNAL */
  wire [COUNT*LANES:0] stored;
  /* verilator lint_on UNUSEDSIGNAL */
  assign stored[COUNT*LANES] = padded[COUNT*LANES];
  genvar g;
  generate
    for (g = 0; g < COUNT; g = g + 1) begin : each
      localparam [GROUP-1:0] HERE = g[GROUP-1:0];
      localparam [GROUP-1:0] BEFORE = HERE - 1'b1;
      wire lower = store && group == HERE;
      wire upper = store && g > 0 && group == BEFORE && !`CELL_FAULT(`FAULT_ALU_STORE);
      wire [LANES-1:0] low_bits = mask[0 +: LANES] & {LANES{lower}};
      wire [LANES-1:0] high_bits = mask[LANES +: LANES] & {LANES{upper}};
      assign stored[g*LANES +: LANES] = (padded[g*LANES +: LANES] & ~low_bits & ~high_bits) |
        (value[0 +: LANES] & low_bits) | (value[LANES +: LANES] & high_bits);
    end
  endgenerate
  assign out = stored[0 +: BITS];
endmodule
