`include "faults.vh"

// Determines when the shift chain loads the held colours: in the clock after the mark's last beat was in the line's
// last cell. Outputs each pixel's colour, extracted from its words, at the refresh port.
module refresh_path #(
  parameter COLOUR_BITS = 64,
  parameter WORD_BITS = 32
) (
  input wire clk,
  input wire reset,
  input wire [15:0] pixels,
  input wire holds,                        // the mark's last beat enters cell 0
  input wire background,                   // 1: the mark contains the colour
  input wire [47:0] colour_field,          // otherwise position of the colour: first bit, width, word of the first bit
  input wire [COLOUR_BITS-1:0] first,      // colour in the shift chain at cell 0
  output wire transfers,
  output wire valid,
  output wire [31:0] colour
);
  localparam [15:0] WORD = WORD_BITS[15:0];
  wire [15:0] base = colour_field[0 +: 16];
  wire [15:0] width = colour_field[16 +: 16];
  wire [15:0] place = base - colour_field[32 +: 16] * WORD;

  // Clocks until the mark has been in all cells; 0 if no mark is in the cells.
  reg [15:0] to_come;
  reg [15:0] left;                         // remaining pixels of the shown line
  reg transfers_next;
  reg [15:0] held_place;
  reg [15:0] held_width;
  reg [15:0] shown_place;
  reg [15:0] shown_width;
  wire leaves = holds ? pixels == 1 : to_come == 1;
  assign transfers = `CELL_FAULT(`FAULT_TRANSFER) ? leaves : transfers_next;
  assign valid = left != 0;

  always @(posedge clk)
    if (reset) {to_come, left, transfers_next} <= 33'd0;
    else begin
      to_come <= holds ? pixels - 16'd1 : to_come != 0 ? to_come - 16'd1 : 16'd0;
      transfers_next <= leaves;
      left <= transfers ? pixels : left != 0 ? left - 16'd1 : 16'd0;
      if (holds) begin
        held_place <= background ? 16'd0 : place;
        held_width <= background ? 16'd32 : width;
      end
      if (transfers) begin
        shown_place <= held_place;
        shown_width <= held_width;
      end
    end

  wire [15:0] at = `CELL_FAULT(`FAULT_COLOUR_PLACE) ? held_place : shown_place;
  /* verilator lint_off UNUSEDSIGNAL */
  wire [COLOUR_BITS+31:0] there = {32'd0, first} >> at;
  /* verilator lint_on UNUSEDSIGNAL */
  assign colour = there[31:0] & ~(32'hffffffff << shown_width);
endmodule
