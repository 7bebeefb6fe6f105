// Synthesised by area.py: trees that deliver several bits per clock. Only their size is used.

// A node of trees that deliver BITS bits of a stream per clock: the carry ripples through them, and that of the highest
// bit is stored.
module area_wide_node #(
  parameter BITS = 2
) (
  input wire clk,
  input wire first,
  input wire [BITS-1:0] multiplicand,
  input wire [BITS-1:0] in,
  output reg [BITS-1:0] left,
  output reg [BITS-1:0] right
);
  reg carry;
  wire [BITS:0] carries;
  assign carries[0] = carry & ~first;
  genvar i;
  generate
    for (i = 0; i < BITS; i = i + 1) begin : place
      assign carries[i+1] = (in[i] & multiplicand[i]) | (in[i] & carries[i]) | (multiplicand[i] & carries[i]);
    end
  endgenerate
  always @(posedge clk) begin
    left <= in;
    right <= in ^ multiplicand ^ carries[BITS-1:0];
    carry <= carries[BITS];
  end
endmodule

// A node of their Y trees of degree 2, like area_node_2 for one bit: its value and its slope. One child receives both a
// clock later, the other receives the values h rows further on. The slope times h arrives DELAY = log2 h bits late,
// through that number of registers: none in half of the nodes, one in a quarter, two in an eighth, so one on average. The
// register of forwarded values holds the last BITS of them.
module area_wide_node_2 #(
  parameter DELAY = 1,
  parameter BITS = 2
) (
  input wire clk,
  input wire first,
  input wire [BITS-1:0] counts,        // the delayed slope belongs to this stream, not the previous one
  input wire [BITS-1:0] square,        // h * h * C
  input wire [BITS-1:0] square_slope,  // 2 * h * C
  input wire [BITS-1:0] value,
  input wire [BITS-1:0] slope,
  output reg [BITS-1:0] left_value,
  output reg [BITS-1:0] left_slope,
  output reg [BITS-1:0] right_value,
  output reg [BITS-1:0] right_slope
);
  wire [BITS-1:0] late;
  generate
    if (DELAY == 0) begin : at_once
      assign late = slope;
    end else begin : delayed
      reg [DELAY-1:0] earlier;
      wire [BITS+DELAY-1:0] seen = {slope, earlier};
      assign late = seen[BITS-1:0];
      always @(posedge clk) earlier <= seen[BITS +: DELAY];
    end
  endgenerate
  reg step_carry, value_carry, slope_carry;
  wire [BITS-1:0] times = late & counts;
  wire [BITS:0] step_carries, value_carries, slope_carries;
  assign step_carries[0] = step_carry & ~first;
  assign value_carries[0] = value_carry & ~first;
  assign slope_carries[0] = slope_carry & ~first;
  wire [BITS-1:0] step = times ^ square ^ step_carries[BITS-1:0];
  genvar i;
  generate
    for (i = 0; i < BITS; i = i + 1) begin : place
      assign step_carries[i+1] = (times[i] & square[i]) | (times[i] & step_carries[i]) | (square[i] & step_carries[i]);
      assign value_carries[i+1] = (value[i] & step[i]) | (value[i] & value_carries[i]) | (step[i] & value_carries[i]);
      assign slope_carries[i+1] = (slope[i] & square_slope[i]) | (slope[i] & slope_carries[i]) |
                                  (square_slope[i] & slope_carries[i]);
    end
  endgenerate
  always @(posedge clk) begin
    left_value <= value;
    left_slope <= slope;
    right_value <= value ^ step ^ value_carries[BITS-1:0];
    right_slope <= slope ^ square_slope ^ slope_carries[BITS-1:0];
    step_carry <= step_carries[BITS];
    value_carry <= value_carries[BITS];
    slope_carry <= slope_carries[BITS];
  end
endmodule
