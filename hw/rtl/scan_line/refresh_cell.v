`include "faults.vh"

// The hold register of a cell, and its stage of the shift chain that returns the colours.
module refresh_cell #(
  parameter BITS = 64
) (
  input wire clk,
  input wire hold,             // a mark stores the colour
  input wire [BITS-1:0] colour,
  input wire transfer,         // the shift chain loads the held colours
  input wire [BITS-1:0] from_right,
  output reg [BITS-1:0] shifting
);
  reg [BITS-1:0] held;
  always @(posedge clk) begin
    if (hold) held <= colour;
    shifting <= transfer ? held : `CELL_FAULT(`FAULT_SHIFT_CHAIN) ? ~from_right : from_right;
  end
endmodule
