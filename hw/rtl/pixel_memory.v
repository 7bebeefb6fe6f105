// The memory of a chip's pixels, MEMORY_BITS bits each (thesis 7.2.1): one or two read ports and a write port, each
// ALU_BITS adjacent bits wide; with OWN_PORT there is a further read port for the scan-out, one bit wide. The number of
// banks is the number of places of the ALU or of bits cleared per clock, whichever is larger.
//
// Addresses arrive one clock before the control word is at the pixels, because the ports register them.
`include "faults.vh"

module pixel_memory #(
  parameter PIXELS = 64,
  parameter MEMORY_BITS = 72,
  parameter MEMORY_READS = 1,
  parameter ALU_BITS = 1,
  parameter BANKS = 1,
  parameter OWN_PORT = 0,
  parameter ADDRESS = 7
) (
  input wire clk,
  input wire [ADDRESS-1:0] early_x,
  /* verilator lint_off UNUSEDSIGNAL */
  input wire [ADDRESS-1:0] early_y,             // with two read ports
  input wire [ADDRESS-1:0] early_shown,         // with a separate port
  /* verilator lint_on UNUSEDSIGNAL */
  input wire [ADDRESS-1:0] early_w,
  input wire [ADDRESS:0] early_count,           // number of bits to clear from that address on
  input wire clear,                             // clears at every pixel; nothing else is written in this clock
  input wire [ALU_BITS-1:0] write,              // places to write
  input wire [PIXELS-1:0] may_write,            // pixels to write
  input wire [PIXELS*ALU_BITS-1:0] written,
  output reg [PIXELS*ALU_BITS-1:0] read_x,
  output reg [PIXELS*ALU_BITS-1:0] read_y,
  output reg [PIXELS-1:0] read_shown
);
  localparam WORDS = (MEMORY_BITS + BANKS - 1) / BANKS;
  localparam ROW = WORDS > 1 ? $clog2(WORDS) : 1;
  localparam PORTS = MEMORY_READS + OWN_PORT;
  localparam OWN = PORTS - 1;
  localparam [31:0] NUMBER = BANKS;
  localparam [31:0] TOP_WORD = (MEMORY_BITS - 1) / BANKS;

  wire [PORTS*BANKS*ROW-1:0] rows;  // by port
  wire [BANKS*ROW-1:0] rows_w;
  wire [ALU_BITS*BANKS-1:0] homes_x;
  wire [ALU_BITS*BANKS-1:0] homes_w;
  memory_port #(.ALU_BITS(ALU_BITS), .BANKS(BANKS), .ADDRESS(ADDRESS), .ROW(ROW)) port_x (
    .clk(clk), .early(early_x), .rows(rows[0 +: BANKS*ROW]), .homes(homes_x));
  memory_port #(.ALU_BITS(ALU_BITS), .BANKS(BANKS), .ADDRESS(ADDRESS), .ROW(ROW)) port_w (
    .clk(clk), .early(early_w), .rows(rows_w), .homes(homes_w));

  // Banks selected by a clear.
  wire [ADDRESS:0] start = {1'b0, early_w} % NUMBER[ADDRESS:0];
  reg [BANKS-1:0] cleared;
  wire [PORTS*BANKS*PIXELS-1:0] delivered;  // by port, then by bank
  genvar b, p;
  generate
    for (b = 0; b < BANKS; b = b + 1) begin : bank
      localparam [31:0] HERE = b;
      localparam [31:0] NEXT = b + BANKS;
      wire [ADDRESS:0] distance = start > HERE[ADDRESS:0] ? NEXT[ADDRESS:0] - start : HERE[ADDRESS:0] - start;
      always @(posedge clk) cleared[b] <= distance < early_count;

      integer i;
      reg [PIXELS-1:0] value;
      reg any;
      always @* begin
        value = {PIXELS{1'b0}};
        any = 1'b0;
        for (i = 0; i < ALU_BITS; i = i + 1)
          if (homes_w[i*BANKS + b]) begin
            value = value | written[i*PIXELS +: PIXELS];
            any = any | write[i];
          end
      end
      wire [ROW-1:0] row = rows_w[b*ROW +: ROW];
      wire held = `FAULT(`FAULT_MEMORY_WRITE) & ~clear & row == TOP_WORD[ROW-1:0] & b == (MEMORY_BITS - 1) % BANKS;
      wire [PORTS*ROW-1:0] bank_rows;
      wire [PORTS*PIXELS-1:0] read;
      for (p = 0; p < PORTS; p = p + 1) begin : port
        assign bank_rows[p*ROW +: ROW] = rows[(p*BANKS + b)*ROW +: ROW];
        assign delivered[(p*BANKS + b)*PIXELS +: PIXELS] = read[p*PIXELS +: PIXELS];
      end
      memory_bank #(.PIXELS(PIXELS), .WORDS(WORDS), .ROW(ROW), .PORTS(PORTS)) cells (
        .clk(clk), .rows(bank_rows), .read(read), .write(clear ? cleared[b] : any & ~held), .row(row),
        .written(clear ? {PIXELS{1'b0}} : value), .mask(clear ? {PIXELS{1'b1}} : may_write));
    end
  endgenerate

  // Routes the banks' bits to the places of the ALU.
  integer j, k;
  always @* begin
    read_x = {(PIXELS*ALU_BITS){1'b0}};
    for (j = 0; j < ALU_BITS; j = j + 1)
      for (k = 0; k < BANKS; k = k + 1)
        if (homes_x[j*BANKS + k])
          read_x[j*PIXELS +: PIXELS] = read_x[j*PIXELS +: PIXELS] | delivered[k*PIXELS +: PIXELS];
  end

  generate
    if (MEMORY_READS > 1) begin : two_reads
      wire [ALU_BITS*BANKS-1:0] homes_y;
      memory_port #(.ALU_BITS(ALU_BITS), .BANKS(BANKS), .ADDRESS(ADDRESS), .ROW(ROW)) port_y (
        .clk(clk), .early(early_y), .rows(rows[BANKS*ROW +: BANKS*ROW]), .homes(homes_y));
      integer m, n;
      always @* begin
        read_y = {(PIXELS*ALU_BITS){1'b0}};
        for (m = 0; m < ALU_BITS; m = m + 1)
          for (n = 0; n < BANKS; n = n + 1)
            if (homes_y[m*BANKS + n])
              read_y[m*PIXELS +: PIXELS] = read_y[m*PIXELS +: PIXELS] | delivered[(BANKS + n)*PIXELS +: PIXELS];
        if (`FAULT(`FAULT_SECOND_READ)) read_y = read_x;
      end
    end else begin : one_read
      always @* read_y = read_x;
    end

    if (OWN_PORT != 0) begin : own_port
      wire [BANKS-1:0] homes_shown;
      memory_port #(.ALU_BITS(1), .BANKS(BANKS), .ADDRESS(ADDRESS), .ROW(ROW)) port_shown (
        .clk(clk), .early(early_shown), .rows(rows[OWN*BANKS*ROW +: BANKS*ROW]), .homes(homes_shown));
      integer n;
      always @* begin
        read_shown = {PIXELS{1'b0}};
        for (n = 0; n < BANKS; n = n + 1)
          if (homes_shown[n]) read_shown = read_shown | delivered[(OWN*BANKS + n)*PIXELS +: PIXELS];
      end
    end else begin : shared_port
      always @* read_shown = read_x[PIXELS-1:0];
    end
  endgenerate
endmodule
