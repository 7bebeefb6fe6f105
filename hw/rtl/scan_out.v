// Shows each picture that the controller has finished, once (docs/machines/pixel-planes.md, "Scan-out"; thesis 7.2.1).
// The colour bits of a row are latched, one bit of all its pixels at a time; then the row is shifted out, PIXELS pixels
// per clock, while the next row is latched. A separate port latches one bit per clock. With a shared port, a refresh
// word is requested from the controller for each bit, and the bit is latched in the clock in which the word is at the
// pixels.
//
// A bit that is read arrives one clock after it counts as latched (pixel_processors.v). It then joins the row; if the
// row is shifted at that edge, the bit is shifted out with it. Rows are stored as one plane of WIDTH pixels per colour
// bit.
`include "faults.vh"

module scan_out #(
  parameter WIDTH = 8,
  parameter HEIGHT = 8,
  parameter PIXELS = 1,        // pixels shown per clock
  parameter COLOUR_BITS = 24,  // maximum number of colour bits of a picture; further bits are omitted
  parameter SHARED = 0,        // 1: bits are read through the pixels' port, by refresh words
  parameter ADDRESS = 7,
  parameter SIDE = 5
) (
  input wire clk,
  input wire reset,
  input wire picture,                        // a picture is finished
  /* verilator lint_off UNUSEDSIGNAL */
  input wire [11:0] picture_base,            // position of its colour in every pixel
  /* verilator lint_on UNUSEDSIGNAL */
  input wire [5:0] picture_width,            // at least 1
  output wire take_picture,
  output wire refresh,                       // requests a refresh word
  output wire [ADDRESS-1:0] refresh_address,
  output wire [SIDE-1:0] refresh_row,
  input wire take_refresh,                   // the controller sends the requested word
  /* verilator lint_off UNUSEDSIGNAL */
  input wire refreshes,                      // a refresh word is at the pixels
  /* verilator lint_on UNUSEDSIGNAL */
  output wire [ADDRESS-1:0] shown_address,   // read at an edge through the separate port
  output wire [SIDE-1:0] shown_row,
  input wire [WIDTH-1:0] line,               // bits that were read
  output reg latched,                        // the last row has been latched
  output reg video_valid,
  output reg video_row,                      // these are the first pixels of a row
  output reg video_frame,                    // these are the first pixels of a picture
  output reg [PIXELS*COLOUR_BITS-1:0] video, // the leftmost pixel first; 0 beyond the row
  output reg shown                           // the picture has been shown completely
);
  localparam GROUPS = (WIDTH + PIXELS - 1) / PIXELS;  // clocks per row
  localparam LEFT = $clog2(GROUPS + 1);
  localparam PADDED = GROUPS * PIXELS;
  localparam [31:0] ALL_GROUPS = GROUPS;
  localparam [31:0] ROWS = HEIGHT;
  localparam [31:0] LAST_ROW = HEIGHT - 1;

  reg showing;
  reg [11:0] base;
  reg [5:0] width;
  reg [SIDE-1:0] row;    // row being latched
  reg [5:0] asked;       // number of bits of the row that were requested
  reg [5:0] held;        // number of bits of the row that were latched
  reg [LEFT-1:0] left;   // clocks until the previous row has been shifted out

  // Actions at an edge: a picture begins; a latched row is loaded into the empty shift register; pixels are shown; a
  // bit is latched or requested.
  assign take_picture = picture & ~showing;
  wire active = picture | showing;
  wire [11:0] base_here = take_picture ? picture_base : base;
  wire [5:0] width_here = take_picture ? picture_width : width;
  wire transfer = showing && held == width && left == 0;
  wire [SIDE-1:0] row_here = take_picture ? 0 : transfer ? row + 1 : row;
  wire [5:0] asked_here = take_picture || transfer ? 0 : asked;
  wire [5:0] held_here = take_picture || transfer ? 0 : held;
  wire [LEFT-1:0] left_here = take_picture ? 0 : transfer ? ALL_GROUPS[LEFT-1:0] : left;
  wire shifts = active && left_here != 0;
  wire may_latch = active && row_here != ROWS[SIDE-1:0] && held_here != width_here;
  wire latches;
  wire asks;
  wire [5:0] held_next = held_here + (latches ? 1 : 0);
  wire [LEFT-1:0] left_next = left_here - (shifts ? 1 : 0);
  wire ends = active && row_here == ROWS[SIDE-1:0] && held_next == 0 && left_next == 0;

  /* verilator lint_off UNUSEDSIGNAL */
  wire [11:0] latch_address = base_here + {6'd0, held_here};
  wire [11:0] ask_address = base_here + {6'd0, asked_here};
  /* verilator lint_on UNUSEDSIGNAL */
  assign shown_address = latch_address[ADDRESS-1:0];
  assign shown_row = `FAULT(`FAULT_SHOWN_ROW) ? row : row_here;
  generate
    if (SHARED != 0) begin : shared
      wire room;
      wire [SIDE-1:0] row_there = row_here + (`FAULT(`FAULT_REFRESH_ROW) & (row_here == LAST_ROW[SIDE-1:0]) ? 1 : 0);
      assign latches = may_latch & refreshes;
      assign asks = may_latch && asked_here != width_here && room;
      fifo #(.DEPTH(2), .BITS(ADDRESS + SIDE)) asked_for (
        .clk(clk), .reset(reset), .drop(1'b0), .in({row_there, ask_address[ADDRESS-1:0]}), .in_valid(asks),
        .in_ready(room), .out({refresh_row, refresh_address}), .out_valid(refresh), .take(take_refresh));
    end else begin : own
      assign latches = may_latch;
      assign asks = 1'b0;
      assign refresh = 1'b0;
      assign refresh_row = 0;
      assign refresh_address = 0;
      /* verilator lint_off UNUSEDSIGNAL */
      wire unused = take_refresh;
      /* verilator lint_on UNUSEDSIGNAL */
    end
  endgenerate

  reg arrives;                 // bits latched at the previous edge are on `line`
  reg [5:0] arrives_at;        // position of these bits in their colours
  always @(posedge clk) begin
    latched <= latches && held_next == width_here && row_here == LAST_ROW[SIDE-1:0];
    shown <= ends;
    arrives <= latches;
    arrives_at <= held_here;
    showing <= active & ~ends;
    base <= base_here;
    width <= width_here;
    row <= row_here;
    asked <= asked_here + (asks ? 1 : 0);
    held <= held_next;
    left <= left_next;
    video_valid <= shifts;
    video_row <= transfer;
    video_frame <= transfer && row == 0;
    if (reset) begin
      {latched, shown, arrives, showing, video_valid, video_row, video_frame} <= 7'b0000000;
      held <= 0;
      left <= 0;
    end
  end

  genvar p, i;
  generate
    for (p = 0; p < COLOUR_BITS; p = p + 1) begin : plane
      localparam [31:0] HERE = p;
      reg [WIDTH-1:0] latch;
      reg [PADDED-1:0] shift;
      wire joins = arrives && arrives_at == HERE[5:0] && !(`FAULT(`FAULT_SCAN_LATE) & transfer);
      wire [WIDTH-1:0] whole = latch | (joins ? line : {WIDTH{1'b0}});
      reg [PADDED-1:0] from;
      always @* begin
        from = shift;
        if (transfer) begin
          from = {PADDED{1'b0}};
          from[WIDTH-1:0] = whole;
        end
      end
      always @(posedge clk) begin
        latch <= reset | transfer ? {WIDTH{1'b0}} : whole;
        if (shifts) shift <= from >> PIXELS;
      end
      for (i = 0; i < PIXELS; i = i + 1) begin : pixel
        always @(posedge clk) if (shifts) video[i*COLOUR_BITS + p] <= from[i];
      end
    end
  endgenerate
endmodule
