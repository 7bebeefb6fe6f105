`include "faults.vh"

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
