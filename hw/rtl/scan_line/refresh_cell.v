`include "faults.vh"

// The hold register of a cell, and its place in the shift chain that brings the colours back.
module refresh_cell #(
  parameter BITS = 64
) (
  input wire clk,
  input wire hold,             // a mark brings the colour to be held
  input wire [BITS-1:0] colour,
  input wire transfer,         // the shift chain takes the held colours
  input wire [BITS-1:0] from_right,
  output reg [BITS-1:0] shifting
);
  reg [BITS-1:0] held;
  always @(posedge clk) begin
    if (hold) held <= colour;
    shifting <= transfer ? held : `CELL_FAULT(`FAULT_SHIFT_CHAIN) ? ~from_right : from_right;
  end
endmodule
