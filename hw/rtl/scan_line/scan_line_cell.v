`include "faults.vh"

// The cell of a pixel (thesis 7.2.2): memory, E, an adder of one word for the running sum, a shifter, an ALU, and
// registers for F and for the two fields read. Each clock it executes the control word of its beat and passes the beat
// on.
module scan_line_cell #(
  parameter WORD_BITS = 32,
  parameter WORDS = 3,
  parameter PORTS = 1,
  parameter ALU_BITS = 32,
  parameter SHIFT_BITS = 32,
  parameter DEGREE = 1,
  parameter ROOTS = 1,
  parameter CLEARS_AT_ONCE = 0
) (
  input wire clk,
  input wire reset,
  // The beat in the cell: its control word; one word each of F, of the difference to the next cell and of the second
  // difference; and words of the constant.
  input wire [CONTROL_BITS-1:0] control,
  input wire [WORD_BITS-1:0] f,
  input wire [WORD_BITS-1:0] a,
  input wire [WORD_BITS-1:0] aa,
  input wire [PORTS*WORD_BITS-1:0] constant,
  // The beat as the next cell receives it in the next clock.
  output reg [CONTROL_BITS-1:0] next_control,
  output reg [WORD_BITS-1:0] next_f,
  output reg [WORD_BITS-1:0] next_a,
  output wire [WORD_BITS-1:0] next_aa,
  output reg [PORTS*WORD_BITS-1:0] next_constant,
  // Return path of the colours.
  input wire transfer,
  input wire [COLOUR_WORDS*WORD_BITS-1:0] from_right,
  output wire [COLOUR_WORDS*WORD_BITS-1:0] shifting,
  output wire enable
);
`include "cell_control.vh"
`include "opcodes.vh"
  localparam F_BITS = F_WORDS * WORD_BITS;
  localparam X_BITS = X_WORDS * WORD_BITS;
  localparam Y_BITS = Y_WORDS * WORD_BITS;
  wire [5:0] opcode = control[CC_OPCODE +: 6];
  genvar p, w;

  wire [F_BITS-1:0] f_now, f_next;
  wire [X_BITS-1:0] x_now, x_moved, result;
  wire [Y_BITS-1:0] y_now, y_moved, y_next;
  wire enabled, writes;

  // Running sum.
  wire [WORD_BITS-1:0] sum;
  cell_adder #(.WORD_BITS(WORD_BITS)) adder (
    .clk(clk), .reset(reset), .first(control[CC_FIRST]), .add(control[CC_ADD]), .one(f), .other(a), .sum(sum));
  wire [WORD_BITS-1:0] difference;
  generate
    if (DEGREE > 1) begin : squares
      reg [WORD_BITS-1:0] moved_aa;
      wire [WORD_BITS-1:0] next_difference;
      cell_adder #(.WORD_BITS(WORD_BITS)) adder (
        .clk(clk), .reset(reset), .first(control[CC_FIRST]), .add(control[CC_ADD]), .one(a), .other(aa),
        .sum(next_difference));
      assign difference = `CELL_FAULT(`FAULT_SECOND_DIFFERENCE) ? a : next_difference;
      always @(posedge clk) moved_aa <= aa;
      assign next_aa = moved_aa;
    end else begin : no_squares
      assign difference = a;
      assign next_aa = aa;
    end
  endgenerate
  always @(posedge clk) begin
    next_control <= reset ? {CONTROL_BITS{1'b0}} : control;
    next_f <= sum;
    next_a <= difference;
    next_constant <= constant;
  end

  // Words from and to memory.
  wire [PORTS*WORD_BITS-1:0] read;
  wire [PORTS*WORD_BITS-1:0] port_mask;
  wire [PORTS*WORD_BITS-1:0] x_word;
  wire [PORTS*WORD_BITS-1:0] y_word;
  wire [PORTS*WORD_BITS-1:0] written;
  wire [PORTS*ADDRESS-1:0] address;
  wire [PORTS-1:0] write;
  wire [PORTS*X_WORDS-1:0] port_takes_x;
  wire [PORTS*Y_WORDS-1:0] port_takes_y;
  cell_memory #(
    .WORD_BITS(WORD_BITS), .WORDS(WORDS), .PORTS(PORTS), .CLEARS_AT_ONCE(CLEARS_AT_ONCE), .ADDRESS(ADDRESS)
  ) memory (
    .clk(clk), .clear(control[CC_FRESH] || (control[CC_CLEAR] && control[CC_DISABLE])), .address(address), .mask(port_mask),
    .write(write), .written(written), .read(read));

  generate
    for (p = 0; p < PORTS; p = p + 1) begin : port
      wire [PORT_BITS-1:0] told = control[CC_PORT + p*PORT_BITS +: PORT_BITS];
      wire [INDEX-1:0] index = told[PORT_INDEX +: INDEX];
      wire [BIT-1:0] low = told[PORT_LOW +: BIT];
      localparam TOP = WORD_BITS - 1;
      localparam [BIT-1:0] TOPMOST = TOP[BIT-1:0];
      wire [WORD_BITS-1:0] mask = {WORD_BITS{1'b1}} << low & ({WORD_BITS{1'b1}} >> TOPMOST - told[PORT_HIGH +: BIT]);
      wire [WORD_BITS-1:0] read_mask = `CELL_FAULT(`FAULT_READ_MASK) ? mask | mask << 1 : mask;
      wire is_fresh = control[CC_FRESH] && !`CELL_FAULT(`FAULT_FRESH);
      wire [WORD_BITS-1:0] from_memory =
        read[p*WORD_BITS +: WORD_BITS] & read_mask & {WORD_BITS{!is_fresh}};
      wire [WORD_BITS-1:0] from_constant = constant[p*WORD_BITS +: WORD_BITS] & mask;
      assign address[p*ADDRESS +: ADDRESS] = told[PORT_ADDRESS +: ADDRESS];
      assign port_mask[p*WORD_BITS +: WORD_BITS] = mask;
      assign x_word[p*WORD_BITS +: WORD_BITS] = control[CC_CONSTANT] ? from_constant : from_memory;
      assign y_word[p*WORD_BITS +: WORD_BITS] = told[PORT_X] ? from_constant : from_memory;

      wire [X_BITS-1:0] f_or_x =
        opcode == LOAD_LINEAR || opcode == KEEP_MAX || opcode == KEEP_MIN ? f_now[0 +: X_BITS] : result;
      wire [X_BITS-1:0] gated;
      for (w = 0; w < X_WORDS; w = w + 1) begin : word
        localparam [INDEX-1:0] HERE = w[INDEX-1:0];
        assign gated[w*WORD_BITS +: WORD_BITS] = f_or_x[w*WORD_BITS +: WORD_BITS] & {WORD_BITS{index == HERE}};
        assign port_takes_x[p*X_WORDS + w] = told[PORT_X] && index == HERE;
      end
      for (w = 0; w < Y_WORDS; w = w + 1) begin : second
        localparam [INDEX-1:0] HERE = w[INDEX-1:0];
        assign port_takes_y[p*Y_WORDS + w] =
          told[PORT_Y] && (index == HERE || (w == 0 && index == 1 && `CELL_FAULT(`FAULT_Y_WORD)));
      end
      wire [WORD_BITS-1:0] word_of_result;
      or_words #(.WORD_BITS(WORD_BITS), .COUNT(X_WORDS)) any (.in(gated), .out(word_of_result));
      assign written[p*WORD_BITS +: WORD_BITS] =
        control[CC_CLEAR] ? {WORD_BITS{1'b0}} : opcode == ENABLE_STORE ? {WORD_BITS{enabled}} : word_of_result;
      localparam LAST = WORDS - 1;
      localparam [ADDRESS-1:0] LAST_WORD = LAST[ADDRESS-1:0];
      wire clears = control[CC_CLEAR] && !(told[PORT_ADDRESS +: ADDRESS] == LAST_WORD && `CELL_FAULT(`FAULT_CLEAR));
      assign write[p] = told[PORT_WRITE] && (clears || (!control[CC_CLEAR] && writes));
    end
  endgenerate

  // Words that the ports deliver to the operands.
  wire [X_WORDS-1:0] takes_x;
  wire [Y_WORDS-1:0] takes_y;
  wire [X_BITS-1:0] into_x;
  wire [Y_BITS-1:0] into_y;
  port_words #(.WORD_BITS(WORD_BITS), .PORTS(PORTS), .COUNT(X_WORDS)) words_of_x (
    .takes(port_takes_x), .words(x_word), .taken(takes_x), .out(into_x));
  port_words #(.WORD_BITS(WORD_BITS), .PORTS(PORTS), .COUNT(Y_WORDS)) words_of_y (
    .takes(port_takes_y), .words(y_word), .taken(takes_y), .out(into_y));
  wire [F_WORDS-1:0] takes_f;
  generate
    for (w = 0; w < F_WORDS; w = w + 1) begin : word_of_f
      localparam [INDEX-1:0] HERE = w[INDEX-1:0];
      assign takes_f[w] = control[CC_KEEP] && control[CC_F_WORD +: INDEX] == HERE &&
        !(`CELL_FAULT(`FAULT_F_WORD) && w == 1);
    end
  endgenerate

  // Operands, and the shifter for one of them.
  wire [1:0] moving = control[CC_MOVE_OPERAND +: 2];
  wire move_f = control[CC_MOVE] && moving == MOVE_F;
  wire move_x = control[CC_MOVE] && moving == MOVE_X;
  wire move_y = control[CC_MOVE] && moving == MOVE_Y;
  wire [INDEX-1:0] move_word = control[CC_MOVE_WORD +: INDEX];
  wire [WORD_BITS-1:0] f_word, f_above, f_below, x_at, x_above, x_below, y_at, y_above, y_below, shifted;
  cell_operand #(.WORD_BITS(WORD_BITS), .COUNT(F_WORDS), .INDEX(INDEX)) register_f (
    .clk(clk), .reset(reset), .first(1'b0), .take(takes_f), .in({F_WORDS{f}}), .move(move_f), .index(move_word),
    .empties(1'b0), .shifted(shifted), .word(f_word), .above(f_above), .below(f_below), .seen(f_now), .moved(f_next),
    .next(f_next));
  cell_operand #(.WORD_BITS(WORD_BITS), .COUNT(X_WORDS), .INDEX(INDEX)) register_x (
    .clk(clk), .reset(reset), .first(control[CC_FIRST] && !`CELL_FAULT(`FAULT_X_KEPT)), .take(takes_x), .in(into_x),
    .move(move_x), .index(move_word), .empties(1'b0), .shifted(shifted), .word(x_at), .above(x_above), .below(x_below),
    .seen(x_now), .moved(x_moved), .next(result));
  cell_operand #(.WORD_BITS(WORD_BITS), .COUNT(Y_WORDS), .INDEX(INDEX)) register_y (
    .clk(clk), .reset(reset), .first(control[CC_FIRST]), .take(takes_y), .in(into_y), .move(move_y), .index(move_word),
    .empties(control[CC_MOVE_LAST] && !`CELL_FAULT(`FAULT_MOVE_ABOVE)), .shifted(shifted), .word(y_at), .above(y_above),
    .below(y_below), .seen(y_now), .moved(y_moved), .next(y_next));
  cell_shifter #(.WORD_BITS(WORD_BITS), .BIT(BIT), .AMOUNT(AMOUNT)) shifter (
    .left(control[CC_MOVE_LEFT]), .amount(control[CC_MOVE_AMOUNT +: AMOUNT]), .moved(control[CC_MOVED +: BIT]),
    .word(move_f ? f_word : move_x ? x_at : y_at), .above(move_f ? f_above : move_x ? x_above : y_above),
    .below(move_f ? f_below : move_x ? x_below : y_below), .out(shifted));

  // ALU.
  wire [GROUP-1:0] group = control[CC_GROUP +: GROUP];
  wire tries = ROOTS != 0 && control[CC_TRY];
  wire linear = control[CC_LINEAR];
  wire [2*LANES-1:0] alu_x, alu_y, taken, value;
  /* verilator lint_off UNUSEDSIGNAL */
  wire root_bit;
  /* verilator lint_on UNUSEDSIGNAL */
  wire less, below, equal, fits;
  wire [F_BITS-1:0] wide_x;
  wire [X_BITS-1:0] wide_y;
  widened #(.FROM(X_BITS), .TO(F_BITS)) wide_as_f (.in(x_now), .out(wide_x));
  widened #(.FROM(Y_BITS), .TO(X_BITS)) wide_as_x (.in(y_now), .out(wide_y));
  two_groups #(.LANES(LANES), .GROUPS(GROUPS), .GROUP(GROUP), .BITS(F_BITS)) groups_x (
    .group(group), .in(linear ? f_now : wide_x), .out(alu_x));
  two_groups #(.LANES(LANES), .GROUPS(GROUPS), .GROUP(GROUP), .BITS(X_BITS)) groups_y (
    .group(group), .in(linear ? x_now : wide_y), .out(alu_y));
  cell_alu #(.LANES(LANES), .ROOTS(ROOTS), .LANE(LANE), .COUNT(COUNT)) alu (
    .clk(clk), .reset(reset), .work(control[CC_WORK]), .begins(control[CC_BEGIN]), .operation(control[CC_FUNCTION +: 3]),
    .low(control[CC_LOW +: LANE]), .count(control[CC_COUNT +: COUNT]), .meeting(control[CC_MEETING +: COUNT]), .try(tries),
    .try_first(control[CC_TRY_FIRST]), .try_second(control[CC_TRY_SECOND]), .try_last(control[CC_TRY_LAST]), .x(alu_x),
    .y(alu_y), .taken(taken), .value(value), .root_bit(root_bit), .less(less), .below(below), .equal(equal), .fits(fits));
  stored_groups #(.LANES(LANES), .GROUP(GROUP), .BITS(X_BITS)) storing (
    .store(control[CC_STORE]), .group(group), .mask(taken), .value(value), .in(x_moved), .out(result));
  generate
    if (ROOTS != 0) begin : roots
      found_root #(.BITS(Y_BITS), .PLACE(PLACE)) root (
        .takes(tries && control[CC_TRY_LAST]), .place(control[CC_TRY_PLACE +: PLACE]), .root_bit(root_bit), .in(y_moved),
        .out(y_next));
    end else begin : no_roots
      assign y_next = y_moved;
    end
  endgenerate

  wire single = |result[0 +: WORD_BITS];
  localparam SIGN = CC_PORT + PORT_HIGH;
  wire sign = f[control[SIGN +: BIT]];
  cell_enable enabling (
    .clk(clk), .reset(reset), .fresh(control[CC_FRESH]), .disables(control[CC_DISABLE]), .act(control[CC_ACT]),
    .opcode(opcode), .single(single), .sign(sign), .less(less), .below(below), .equal(equal), .fits(fits),
    .enabled(enabled), .writes(writes), .enable(enable));

  wire holds = control[CC_HOLD] && (enabled || !`CELL_FAULT(`FAULT_HOLD));
  refresh_cell #(.BITS(COLOUR_WORDS * WORD_BITS)) refreshing (
    .clk(clk), .hold(holds), .colour(result[0 +: COLOUR_WORDS * WORD_BITS]), .transfer(transfer), .from_right(from_right),
    .shifting(shifting));
endmodule
