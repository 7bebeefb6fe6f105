// The machine's end of the link: a register that collects words of LINK bits until a command is complete, and holds the
// command until it is taken (docs/instruction-set.md, "On a link"; docs/machines/pixel-planes.md, "Link"). A word is
// stored at an edge; a command whose last word arrives at an edge can be taken at the next edge, at which the next
// command's first word is also accepted.
`include "faults.vh"

module receiver #(
  parameter LINK = 32
) (
  input wire clk,
  input wire reset,
  input wire drop,                         // drops the collected words
  input wire [LINK-1:0] word,
  input wire word_valid,
  output wire take_word,
  output wire whole,                       // a command is complete
  output wire [COMMAND_BITS-1:0] command,
  input wire take                          // the command is taken at this edge
);
`include "command.vh"

  localparam REGISTER = ((COMMAND_BITS + LINK - 1) / LINK) * LINK;
  localparam [31:0] EACH = LINK;
  /* verilator lint_off UNUSEDSIGNAL */
  reg [REGISTER-1:0] gathered;  // the last word may extend beyond the longest command
  /* verilator lint_on UNUSEDSIGNAL */
  reg [8:0] count;              // number of bits collected

  assign command = gathered[COMMAND_BITS-1:0];
  wire [5:0] number = gathered[5:0];

  // Number of bits of the command, without coefficients and constant.
  reg [8:0] fixed;
  reg linear;
  reg constant;
  reg behind_field;  // the width of the coefficients follows a field
  always @* begin
    fixed = 6;
    linear = 1'b0;
    constant = 1'b0;
    behind_field = 1'b0;
    case (number)
      ENABLE_LOAD, ENABLE_AND, ENABLE_AND_NOT, ENABLE_OR, ENABLE_XOR, ENABLE_STORE, ROOT, FRAME_END: fixed = 6 + 18;
      EDGE_NOT_NEGATIVE, EDGE_NEGATIVE, STRIPE: begin
        fixed = 6 + 12;
        linear = 1'b1;
      end
      LINEAR_GE, LINEAR_GT, LINEAR_LE, LINEAR_LT, LINEAR_EQ, LOAD_LINEAR, KEEP_MAX, KEEP_MIN, LINEAR_PLUS,
      LINEAR_MINUS: begin
        fixed = 6 + 18 + 12;
        linear = 1'b1;
        behind_field = 1'b1;
      end
      SQUARES: begin
        fixed = 6 + 6;
        linear = 1'b1;
      end
      SET_CONSTANT, XOR_CONSTANT: begin
        fixed = 6 + 18;
        constant = 1'b1;
      end
      COPY, FIELD_LT, FIELD_LE, FIELD_EQ, BIT_NOT, ADD: fixed = 6 + 2 * 18;
      BIT_AND, BIT_OR, BIT_XOR, BIT_AND_NOT: fixed = 6 + 3 * 18;
      SKIP_IF_NONE: fixed = 6 + 32;
      SEGMENT: fixed = 6 + 4 * 16;
      default: ;
    endcase
  end
  wire [8:0] width = {3'd0, behind_field ? gathered[FIELD_1 +: 6] : gathered[FIELD_0 +: 6]};
  wire [8:0] target_width = {3'd0, gathered[FIELD_0 + BASE_BITS +: 6]};
  wire [8:0] bits = fixed + (linear ? width + (width << 1) : 9'd0) +
                    (constant & ~`FAULT(`FAULT_CONSTANT) ? target_width : 9'd0);

  assign whole = count >= 6 && count >= fixed && count >= bits;
  assign take_word = word_valid & ~drop & (~whole | take);
  always @(posedge clk) begin
    if (reset | drop) count <= 0;
    else if (take | take_word) count <= (take ? 9'd0 : count) + (take_word ? EACH[8:0] : 9'd0);
  end

  // Each word has a fixed position; bits beyond the last word are 0.
  genvar w;
  generate
    for (w = 0; w < REGISTER / LINK; w = w + 1) begin : place
      localparam [31:0] BELOW = w * LINK;
      wire here = take_word && (take ? w == 0 : count == BELOW[8:0]);
      always @(posedge clk) begin
        if (reset | drop | (take & ~here)) gathered[w*LINK +: LINK] <= {LINK{1'b0}};
        else if (here) gathered[w*LINK +: LINK] <= word;
      end
    end
  endgenerate
endmodule
