// Computes the control word and coefficient bits of one clock of an instruction from its command; combinational (thesis
// 7.2.1; hw/isa/opcodes.h defines each instruction, docs/instruction-set.md its clocks).
//
// F is compared with a field from its lowest bit on, after `shift` bits of fraction. K holds the comparison of the bits
// processed; it starts with the result for two empty numbers. The bits of F above the field are compared with zeros;
// if F is negative, it is less than any field. With one read port, instructions that read two fields latch a bit of
// field s first, then combine it with the bit of the other field.
//
// A root of w bits has w turns. In turn k, from 0, the k + 3 bits of the field from 2(w - 1 - k) up are four times the
// remainder plus two more bits. The turn subtracts 4q + 1, where q is the k-bit partial root stored above them; or, if
// the remainder was negative, as recorded in G, it adds 4q + 3. In both cases the added number begins with a bit 1; a
// subtraction also has a carry in. The top bit of the result is the sign; its inverse is the next bit of the root.
`include "faults.vh"

module sequencer #(
  parameter MEMORY_READS = 1,
  parameter ALU_BITS = 1,
  parameter ADDRESS = 7,
  parameter SIDE = 5,
  parameter DEGREE = 1   // 2: adds the coefficients of squares to linear expressions
) (
  input wire [COMMAND_BITS-1:0] command,
  /* verilator lint_off UNUSEDSIGNAL */
  input wire [SQUARES_BITS-1:0] squares,  // coefficients stored by a preceding `squares`, otherwise 0
  /* verilator lint_on UNUSEDSIGNAL */
  input wire [5:0] at,    // first bit of the stream or field in this clock
  input wire pass,        // second pass through a stream, or second of two reads
  input wire [5:0] turn,  // turn of a root, in which `at` counts from 0
  output reg [CONTROL_BITS-1:0] control,
  output reg first,       // first bit of a stream
  output reg a,
  output reg b,
  output reg c,
  output reg xx,
  output reg xy,
  output reg yy,
  output reg [5:0] next_at,
  output reg next_pass,
  output reg [5:0] next_turn,
  output reg last
);
`include "command.vh"
`include "control_word.vh"

  localparam [31:0] ALU = ALU_BITS;
  localparam FRACTION = 6;  // offset of the fraction in a linear expression's head, after the width

  wire [5:0] number = command[5:0];
  wire [6:0] at_7 = {1'b0, at};
  wire [11:0] at_12 = {6'd0, at};
  wire [11:0] base_0 = command[FIELD_0 +: 12];
  wire [11:0] base_1 = command[FIELD_1 +: 12];
  wire [11:0] base_2 = command[FIELD_2 +: 12];
  wire [5:0] width_0 = command[FIELD_0 + BASE_BITS +: 6];
  wire [5:0] width_1 = command[FIELD_1 + BASE_BITS +: 6];

  // Linear expression.
  wire no_field = number == EDGE_NOT_NEGATIVE || number == EDGE_NEGATIVE || number == STRIPE;
  wire [5:0] width = no_field ? command[FIELD_0 +: 6] : command[FIELD_1 +: 6];
  wire [5:0] shift = no_field ? command[FIELD_0 + FRACTION +: 6] : command[FIELD_1 + FRACTION +: 6];
  wire [7:0] at_a = (no_field ? 8'd18 : 8'd36) + {2'd0, at};
  wire [7:0] at_b = at_a + {2'd0, width};
  wire [7:0] at_c = at_b + {2'd0, width};
  wire [7:0] at_xy = {2'd0, at} + {2'd0, width};
  wire [7:0] at_yy = at_xy + {2'd0, width};
  wire twice = number == KEEP_MAX || number == KEEP_MIN;
  wire stream = (number >= EDGE_NOT_NEGATIVE && number <= KEEP_MIN) || number == STRIPE || number == LINEAR_PLUS ||
                number == LINEAR_MINUS;

  wire sign = at + 6'd1 == width;
  wire whole = at >= shift;  // not part of the fraction
  wire [5:0] place = at - shift;
  wire in_field = whole && place < width_0;
  wire begins_field = whole && place == 0;

  // Roots.
  wire takes_root = number == ROOT;
  wire [5:0] root_bits = width_0 >> 1;
  wire of_root = takes_root && at >= 2 && at < turn + 6'd2;
  wire ends_turn = at == turn + 6'd2;
  wire ends_root = ends_turn && turn + 6'd1 == root_bits;
  wire [5:0] below = root_bits - 6'd1 - turn;
  wire [11:0] remainder = base_0 + {5'd0, below, 1'b0} + at_12;
  wire [11:0] root = base_0 + {5'd0, root_bits, 1'b0} - {6'd0, turn} - 12'd1 + at_12;

  // Fields.
  wire one_step = number <= ENABLE_STORE || number == GLOBAL_OR || number == SKIP_IF_NONE || number == SQUARES;
  wire two_fields = (number >= FIELD_LT && number <= BIT_AND_NOT) || number == ADD;
  wire two_clocks = (two_fields || of_root) && MEMORY_READS == 1;
  wire latching = two_clocks && !pass;
  wire [6:0] end_of_step = at_7 + ALU[6:0];
  wire ends_field = end_of_step >= {1'b0, width_0};
  /* verilator lint_off UNUSEDSIGNAL */
  wire [31:0] constant = command[24 +: 32] >> at;

  reg [1:0] x_select;
  reg [1:0] carry_in;
  reg y_enable, y_zero, y_invert, ripple, sum, invert, write, write_all, write_selected, latch;
  reg set_enable, and_enable, set_carry, select, question, x_by_flag, set_flag;
  reg [ALU_BITS-1:0] x_zero;
  reg [ALU_BITS-1:0] x_invert;
  reg [ALU_BITS-1:0] active;
  reg [11:0] address_x;
  reg [11:0] address_y;
  reg [11:0] address_w;
  /* verilator lint_on UNUSEDSIGNAL */

  // Places that have a bit of the target field, and places that have a bit of `s` in `add`.
  wire [ALU_BITS-1:0] in_target;
  wire [ALU_BITS-1:0] in_second;
  genvar i;
  generate
    for (i = 0; i < ALU_BITS; i = i + 1) begin : place_of
      localparam [31:0] PLACE = i;
      assign in_target[i] = at_7 + PLACE[6:0] < {1'b0, width_0};
      assign in_second[i] = at_7 + PLACE[6:0] < {1'b0, width_1};
    end
  endgenerate

  // Tasks read only signals that the block below also reads, because a simulator does not derive the block's
  // sensitivity from tasks.

  // Selects two operands: x is s, y is the other field.
  task meet(input [11:0] base_x, input [11:0] base_y);
    begin
      address_x = base_x + at_12;
      address_y = base_y + at_12;
      y_zero = 1'b0;
    end
  endtask

  // K := whether x > y, or x >= y, for the bits processed.
  task compare(input or_equal, input is_first);
    begin
      y_zero = 1'b0;
      y_invert = 1'b1;
      ripple = 1'b1;
      sum = 1'b0;
      carry_in = !is_first ? CARRY_KEPT : or_equal ? CARRY_ONE : CARRY_ZERO;
      set_carry = 1'b1;
    end
  endtask

  // Compares F with field 0: K holds whether F is greater (or equal), once the sign is processed.
  task compare_stream(input or_equal);
    begin
      active[0] = whole;
      if (whole) begin
        compare(or_equal, begins_field);
        if (!in_field) y_zero = 1'b1;  // inverted y is 1: beyond the field its bits count as 0
        if (sign) begin                // a negative F is less than any field
          x_invert[0] = 1'b1;
          y_invert = 1'b0;
        end
      end
      address_y = base_0 + {6'd0, place};
    end
  endtask

  always @* begin
    x_select = stream ? X_TREE : two_fields && two_clocks && pass ? X_LATCH : X_MEMORY;
    carry_in = CARRY_ZERO;
    {y_enable, y_zero, y_invert, ripple, sum, invert} = 6'b010010;
    {write, write_all, write_selected, latch} = 4'b0000;
    {set_enable, and_enable, set_carry, select, question, x_by_flag, set_flag} = 7'b0000000;
    x_zero = {ALU_BITS{1'b0}};
    x_invert = {ALU_BITS{1'b0}};
    active = {ALU_BITS{1'b0}};
    active[0] = 1'b1;
    address_x = base_0 + at_12;
    address_y = base_0 + at_12;
    address_w = base_0 + at_12;
    if (!stream && !one_step && !takes_root) active = in_target;

    case (number)
      ENABLE_ALL: begin
        set_enable = 1'b1;
        x_zero[0] = 1'b1;
        x_invert[0] = 1'b1;
      end
      ENABLE_INVERT: begin
        set_enable = 1'b1;
        x_select = X_ENABLE;
        x_invert[0] = 1'b1;
      end
      ENABLE_LOAD: set_enable = 1'b1;
      ENABLE_AND: {set_enable, and_enable} = 2'b11;
      ENABLE_AND_NOT: begin
        {set_enable, and_enable} = 2'b11;
        x_invert[0] = 1'b1;
      end
      ENABLE_OR: begin  // carry out of x + E + 1
        set_enable = 1'b1;
        {y_enable, y_zero, sum} = 3'b100;
        carry_in = CARRY_ONE;
      end
      ENABLE_XOR: begin
        set_enable = 1'b1;
        {y_enable, y_zero} = 2'b10;
      end
      ENABLE_STORE: begin
        x_select = X_ENABLE;
        {write, write_all} = 2'b11;
      end

      EDGE_NOT_NEGATIVE: begin
        {set_enable, and_enable} = {2{sign}};
        x_invert[0] = 1'b1;
      end
      EDGE_NEGATIVE, STRIPE: {set_enable, and_enable} = {2{sign}};
      LINEAR_GE, LINEAR_GT: begin
        compare_stream(number == LINEAR_GE);
        {set_enable, and_enable} = {2{sign}};
      end
      LINEAR_LT, LINEAR_LE: begin
        compare_stream(number == LINEAR_LT);
        {set_enable, and_enable} = {2{sign}};
        invert = 1'b1;
      end
      LINEAR_EQ: begin  // the sum of x, y and 1 is 1 where they are equal
        {set_enable, and_enable} = {2{whole}};
        y_zero = !in_field;
        carry_in = CARRY_ONE;
        address_y = base_0 + {6'd0, place};
      end
      LOAD_LINEAR: begin  // a 1 beyond the field, or a sign, means that F does not fit
        write = in_field;
        {set_enable, and_enable} = {2{whole && !in_field}};
        x_invert[0] = whole && !in_field;
        address_w = base_0 + {6'd0, place};
      end
      KEEP_MAX, KEEP_MIN: begin
        if (!pass) begin
          compare_stream(number == KEEP_MIN);
          select = sign;
          invert = number == KEEP_MIN;
        end else begin
          write = in_field;
          write_selected = 1'b1;
          if (whole && !in_field) begin  // inverted carry out of x + K: F does not fit
            {set_enable, and_enable} = 2'b11;
            {sum, invert} = 2'b01;
            carry_in = CARRY_KEPT;
          end
        end
        address_w = base_0 + {6'd0, place};
      end

      LINEAR_PLUS, LINEAR_MINUS: begin
        active[0] = in_field;
        {write, set_carry} = {2{in_field}};
        y_zero = 1'b0;
        y_invert = number == LINEAR_MINUS;
        carry_in = !begins_field ? CARRY_KEPT
                   : number == LINEAR_MINUS && !`FAULT(`FAULT_DIFFERENCE) ? CARRY_ONE : CARRY_ZERO;
        address_y = base_0 + {6'd0, place};
        address_w = base_0 + {6'd0, place};
      end
      ROOT: begin
        x_select = of_root && (latching || MEMORY_READS > 1) ? X_MEMORY : X_LATCH;
        address_x = root;
        address_y = remainder;
        address_w = remainder;
        write = 1'b1;
        y_zero = ends_turn && turn == 0;  // this bit is not part of the number
        y_invert = ends_turn;
        x_zero[0] = !of_root;
        x_invert[0] = at < 2 || (ends_turn && turn == 0);
        x_by_flag = of_root || (ends_turn && turn != 0);
        carry_in = at == 0 ? CARRY_ZERO : CARRY_KEPT;
        set_carry = !ends_turn;
        set_flag = ends_turn;
      end

      SET_CONSTANT: begin
        write = 1'b1;
        x_zero = {ALU_BITS{1'b1}};
        x_invert = constant[ALU_BITS-1:0];
      end
      XOR_CONSTANT: begin
        write = 1'b1;
        x_invert = constant[ALU_BITS-1:0];
      end
      COPY: begin
        write = 1'b1;
        address_x = base_1 + at_12;
      end
      BIT_NOT: begin
        write = 1'b1;
        x_invert = {ALU_BITS{1'b1}};
        address_x = base_1 + at_12;
      end
      FIELD_LT, FIELD_LE: begin
        meet(base_0, base_1);
        compare(number == FIELD_LT || `FAULT(`FAULT_DECODE), at == 0);
        {set_enable, and_enable} = {2{ends_field}};
        invert = 1'b1;
      end
      FIELD_EQ: begin
        meet(base_0, base_1);
        {set_enable, and_enable} = 2'b11;
        carry_in = CARRY_ONE;
      end
      BIT_AND, BIT_AND_NOT: begin  // carry out of x + y
        meet(base_1, base_2);
        write = 1'b1;
        sum = 1'b0;
        y_invert = number == BIT_AND_NOT;
      end
      BIT_OR: begin  // carry out of x + y + 1
        meet(base_1, base_2);
        write = 1'b1;
        sum = 1'b0;
        carry_in = CARRY_ONE;
      end
      BIT_XOR: begin
        meet(base_1, base_2);
        write = 1'b1;
      end
      ADD: begin
        meet(base_1, base_0);
        write = 1'b1;
        ripple = 1'b1;
        set_carry = 1'b1;
        carry_in = at == 0 ? CARRY_ZERO : CARRY_KEPT;
        x_zero = ~in_second;
      end
      GLOBAL_OR, SKIP_IF_NONE: question = 1'b1;
      default: ;
    endcase

    if (latching) begin
      {write, set_enable, set_carry, x_by_flag} = 4'b0000;
      latch = 1'b1;
      if (number == ADD) active = in_second;
    end

    control = {CONTROL_BITS{1'b0}};
    control[CW_X_SELECT +: 2] = x_select;
    control[CW_Y_ENABLE] = y_enable;
    control[CW_Y_ZERO] = y_zero;
    control[CW_Y_INVERT] = y_invert;
    control[CW_X_ZERO +: ALU_BITS] = x_zero;
    control[CW_X_INVERT +: ALU_BITS] = x_invert;
    control[CW_ACTIVE +: ALU_BITS] = active;
    control[CW_CARRY_IN +: 2] = carry_in;
    control[CW_RIPPLE] = ripple;
    control[CW_SUM] = sum;
    control[CW_INVERT] = invert;
    control[CW_WRITE] = write;
    control[CW_WRITE_ALL] = write_all;
    control[CW_WRITE_SELECTED] = write_selected;
    control[CW_LATCH] = latch;
    control[CW_SET_ENABLE] = set_enable;
    control[CW_AND_ENABLE] = and_enable;
    control[CW_SET_CARRY] = set_carry;
    control[CW_SELECT] = select;
    control[CW_STREAM] = stream;
    control[CW_QUESTION] = question;
    control[CW_X_BY_FLAG] = x_by_flag;
    control[CW_SET_FLAG] = set_flag;
    control[CW_X +: ADDRESS] = MEMORY_READS == 1 && x_select != X_MEMORY ? address_y[ADDRESS-1:0] : address_x[ADDRESS-1:0];
    control[CW_Y +: ADDRESS] = address_y[ADDRESS-1:0];
    control[CW_W +: ADDRESS] = address_w[ADDRESS-1:0];

    first = stream && at == 0;
    a = stream && command[at_a];
    b = stream && command[at_b];
    c = stream && command[at_c];
    xx = DEGREE > 1 && stream && squares[{2'd0, at}];
    xy = DEGREE > 1 && stream && squares[at_xy];
    yy = DEGREE > 1 && stream && squares[at_yy];
    last = one_step ||
           (stream ? sign && (!twice || pass) : takes_root ? ends_root : ends_field && !latching);
    next_at = stream ? (sign ? 6'd0 : at + 6'd1)
              : latching ? at
              : takes_root ? (ends_turn ? 6'd0 : at + 6'd1) : end_of_step[5:0];
    next_turn = ends_turn && takes_root ? turn + 6'd1 : turn;
    next_pass = stream ? pass | sign : latching;
  end
endmodule
