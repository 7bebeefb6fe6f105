// The machine's end of the link: a FIFO, and a register that gathers words until a command is whole. At which edge a word
// moves is docs/machines/pixel-planes-4.md, "Link".

module receiver #(
  parameter LINK = 32
) (
  input wire clk,
  input wire reset,
  input wire drop,
  input wire [LINK-1:0] word,
  input wire word_valid,
  output wire take_word,
  output wire whole,                       // a command is in the register
  output wire [COMMAND_BITS-1:0] command,
  input wire take                          // and is taken at this edge
);
`include "command.vh"

  localparam REGISTER = ((COMMAND_BITS + LINK - 1) / LINK) * LINK;
  reg [REGISTER-1:0] gathered;
  reg [8:0] count;  // bits

  assign command = gathered[COMMAND_BITS-1:0];
  wire [5:0] number = gathered[5:0];

  // The bits that can be told before the width of a linear expression or a constant is known, and where that width is.
  reg [8:0] fixed;
  reg linear;
  reg constant;
  always @* begin
    linear = 1'b0;
    constant = 1'b0;
    case (number)
      ENABLE_ALL, ENABLE_INVERT, GLOBAL_OR, SEGMENT_END: fixed = 6;
      ENABLE_LOAD, ENABLE_AND, ENABLE_AND_NOT, ENABLE_OR, ENABLE_XOR, ENABLE_STORE, ROOT: fixed = 6 + FIELD_BITS;
      EDGE_NOT_NEGATIVE, EDGE_NEGATIVE, STRIPE: begin
        fixed = 6 + 12;
        linear = 1'b1;
      end
      LINEAR_GE, LINEAR_GT, LINEAR_LE, LINEAR_LT, LINEAR_EQ, LOAD_LINEAR, KEEP_MAX, KEEP_MIN, LINEAR_PLUS,
      LINEAR_MINUS: begin
        fixed = 6 + FIELD_BITS + 12;
        linear = 1'b1;
      end
      SET_CONSTANT, XOR_CONSTANT: begin
        fixed = 6 + FIELD_BITS;
        constant = 1'b1;
      end
      COPY, FIELD_LT, FIELD_LE, FIELD_EQ, BIT_NOT, ADD: fixed = 6 + 2 * FIELD_BITS;
      BIT_AND, BIT_OR, BIT_XOR, BIT_AND_NOT: fixed = 6 + 3 * FIELD_BITS;
      SKIP_IF_NONE: fixed = 6 + 32;
      SEGMENT: fixed = 6 + 4 * 16;
      FRAME_END: fixed = 6 + FIELD_BITS;
      default: fixed = 6;
    endcase
  end
  wire [5:0] width = gathered[(fixed == 6 + 12 ? FIELD_0 : FIELD_1) +: 6];
  wire [5:0] target_width = gathered[FIELD_0 + BASE_BITS +: 6];
  wire [8:0] bits = fixed + (linear ? {3'd0, width} + {2'd0, width, 1'b0} : 9'd0) +
                    (constant ? {3'd0, target_width} : 9'd0);

  assign whole = count >= 6 && count >= fixed && count >= bits;
  assign take_word = word_valid & ~drop & (~whole | take);
  wire [REGISTER-1:0] placed = {{(REGISTER-LINK){1'b0}}, word} << count;

  always @(posedge clk) begin
    if (reset | drop) begin
      gathered <= {REGISTER{1'b0}};
      count <= 0;
    end else if (take) begin
      gathered <= take_word ? {{(REGISTER-LINK){1'b0}}, word} : {REGISTER{1'b0}};
      count <= take_word ? LINK : 0;
    end else if (take_word) begin
      gathered <= gathered | placed;
      count <= count + LINK;
    end
  end
endmodule
