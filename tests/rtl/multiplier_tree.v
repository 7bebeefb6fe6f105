// The serial multiplier trees of the Linear Expression Evaluator (thesis 7.2.1 and fig. 7.1). Written from
// docs/machines/pixel-planes-4.md: a node passes its input on, a clock later, to one child, and to the other the sum of its input
// and the multiplicand's bit, from a one-bit adder that keeps its carry.
//
// Streams come least significant bit first and back to back. Level k of n (the root is level 0) gets a stream k clocks
// after the root. The multiplicand enters n - 1 clocks after the stream, on a wire that all levels share, so that at level k
// it is worth 2^(n - 1 - k) times itself.
`include "faults.vh"

// What the levels of a tree share: where streams begin, and from when on the multiplicand counts. At level k that is from
// bit n - 1 - k of its stream on; until then the wire has the end of the stream before.
module tree_levels #(
  parameter LEVELS = 3
) (
  input wire clk,
  input wire reset,
  input wire [3:0] fault,
  input wire first,                // a stream's first bit is at the root
  output wire [LEVELS:0] begins,   // or at level k; the last are the leaves
  output wire [LEVELS:0] counts
);
  reg [LEVELS:0] passed;
  assign begins = passed | first;
  always @(posedge clk) passed <= reset ? {(LEVELS+1){1'b0}} : begins << 1;

  genvar k;
  generate
    for (k = 0; k <= LEVELS; k = k + 1) begin : level
      // The stream at level k began j clocks ago if begins[k + j] is 1.
      if (k + 1 < LEVELS) assign counts[k] = ~|begins[LEVELS-2:k] | `FAULT(`FAULT_TREE_SELECT);
      else assign counts[k] = 1'b1;
    end
  endgenerate
endmodule

module tree_node (
  input wire clk,
  input wire reset,
  input wire [3:0] fault,
  input wire first,
  input wire multiplicand,
  input wire in,
  output reg left,
  output reg right
);
  reg carry;
  wire kept = carry & (~first | `FAULT(`FAULT_TREE_ADDER));
  always @(posedge clk) begin
    if (reset) begin
      left <= 1'b0;
      right <= 1'b0;
      carry <= 1'b0;
    end else begin
      left <= in;
      right <= in ^ multiplicand ^ kept;
      carry <= (in & multiplicand) | (in & kept) | (multiplicand & kept);
    end
  end
endmodule

// Adds multiplicand * i to the stream for each leaf i. Node 1 is the root, those below node n are 2n and 2n + 1, and leaf i
// is number LEAVES_ROUNDED + i. Nodes that have no leaf are left out.
module multiplier_tree #(
  parameter LEAVES = 8,
  parameter LEVELS = 3
) (
  input wire clk,
  input wire reset,
  input wire [3:0] fault,
  input wire [LEVELS:0] begins,
  input wire [LEVELS:0] counts,
  input wire multiplicand,
  input wire in,
  output wire [LEAVES-1:0] out
);
  localparam ROUNDED = 1 << LEVELS;
  wire [2*ROUNDED-1:0] stream;
  assign stream[0] = 1'b0;
  assign stream[1] = in;
  assign out = stream[ROUNDED +: LEAVES];

  genvar k, i;
  generate
    for (k = 0; k < LEVELS; k = k + 1) begin : level
      for (i = 0; i < (1 << k); i = i + 1) begin : at
        if (i << (LEVELS - k) < LEAVES) begin : there
          tree_node node (
            .clk(clk), .reset(reset), .fault(fault), .first(begins[k]), .multiplicand(multiplicand & counts[k]),
            .in(stream[(1 << k) + i]), .left(stream[2 * ((1 << k) + i)]), .right(stream[2 * ((1 << k) + i) + 1]));
        end else begin : missing
          assign stream[2 * ((1 << k) + i) +: 2] = 2'b00;
        end
      end
    end
  endgenerate
endmodule

// A wire with so many registers.
module delay #(
  parameter LENGTH = 0,
  parameter BITS = 1
) (
  input wire clk,
  input wire reset,
  input wire [BITS-1:0] in,
  output wire [BITS-1:0] out
);
  generate
    if (LENGTH == 0) begin : none
      assign out = in;
    end else begin : some
      reg [LENGTH*BITS-1:0] line;
      assign out = line[(LENGTH-1)*BITS +: BITS];
      if (LENGTH == 1) always @(posedge clk) line <= reset ? {BITS{1'b0}} : in;
      else always @(posedge clk) line <= reset ? {(LENGTH*BITS){1'b0}} : {line[(LENGTH-1)*BITS-1:0], in};
    end
  endgenerate
endmodule

// A*x + B*y + C at every pixel, a bit a clock, LEVELS_X + LEVELS_Y clocks after its bits of A, B and C. Pixel (x, y) is
// bit y * WIDTH + x.
module linear_expression_evaluator #(
  parameter WIDTH = 8,
  parameter HEIGHT = 8,
  parameter LEVELS_X = 3,
  parameter LEVELS_Y = 3
) (
  input wire clk,
  input wire reset,
  input wire [3:0] fault,
  input wire first,
  input wire a,
  input wire b,
  input wire c,
  output wire [WIDTH*HEIGHT-1:0] leaves
);
  // A wire that no level looks at has no length; B is needed when C's sums come out of the X tree, and later.
  localparam DELAY_A = LEVELS_X > 0 ? LEVELS_X - 1 : 0;
  localparam DELAY_B = LEVELS_Y > 0 ? LEVELS_X + LEVELS_Y - 1 : 0;

  wire [LEVELS_X:0] begins_x;
  wire [LEVELS_X:0] counts_x;
  wire [LEVELS_Y:0] begins_y;
  wire [LEVELS_Y:0] counts_y;
  wire late_a;
  wire late_b;
  wire early_b;
  wire [WIDTH-1:0] columns;

  delay #(.LENGTH(DELAY_A)) delay_a (.clk(clk), .reset(reset), .in(a), .out(late_a));
  delay #(.LENGTH(DELAY_B > 0 ? DELAY_B - 1 : 0)) delay_early_b (.clk(clk), .reset(reset), .in(b), .out(early_b));
  delay #(.LENGTH(DELAY_B > 0 ? 1 : 0)) delay_b (.clk(clk), .reset(reset), .in(early_b), .out(late_b));

  tree_levels #(.LEVELS(LEVELS_X)) x_levels (
    .clk(clk), .reset(reset), .fault(fault), .first(first), .begins(begins_x), .counts(counts_x));
  tree_levels #(.LEVELS(LEVELS_Y)) y_levels (
    .clk(clk), .reset(reset), .fault(fault), .first(begins_x[LEVELS_X]), .begins(begins_y), .counts(counts_y));

  multiplier_tree #(.LEAVES(WIDTH), .LEVELS(LEVELS_X)) x_tree (
    .clk(clk), .reset(reset), .fault(fault), .begins(begins_x), .counts(counts_x), .multiplicand(late_a), .in(c),
    .out(columns));

  genvar x, y;
  generate
    for (x = 0; x < WIDTH; x = x + 1) begin : column
      wire [HEIGHT-1:0] rows;
      multiplier_tree #(.LEAVES(HEIGHT), .LEVELS(LEVELS_Y)) y_tree (
        .clk(clk), .reset(reset), .fault(fault), .begins(begins_y), .counts(counts_y),
        .multiplicand(`FAULT(`FAULT_TREE_DELAY) ? early_b : late_b), .in(columns[x]), .out(rows));
      for (y = 0; y < HEIGHT; y = y + 1) begin : row
        assign leaves[y*WIDTH + x] = rows[y];
      end
    end
  endgenerate
endmodule
