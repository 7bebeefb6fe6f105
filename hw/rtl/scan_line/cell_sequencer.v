`include "faults.vh"

// Computes the control word of a beat that enters, and steps through the accesses, moves and bits of its packet. A
// chain has only one sequencer, because all cells get the same packets. Inputs are as in hw/scan_line/packet.h; a field
// is given by its first bit, its width, the first memory word that contains it, and the number of these words.
//
// Beat r / PORTS reads word r of the fields to read; word w of the target is written w / PORTS beats after the beat of
// the result. From beat `work_from` on the shifter and the ALU work, one operation per clock.
module cell_sequencer #(
  parameter WORD_BITS = 32,
  parameter WORDS = 3,
  parameter PORTS = 1,
  parameter ALU_BITS = 32,
  parameter SHIFT_BITS = 32,
  parameter ROOTS = 1,
  parameter CLEARS_AT_ONCE = 0
) (
  input wire clk,
  input wire reset,
  input wire [1:0] kind,               // see KIND_...
  input wire begins_line,
  input wire background,
  input wire [15:0] number,
  input wire [15:0] words,
  input wire [15:0] beats,
  input wire [63:0] first_source,      // unpacked below
  input wire [63:0] second_source,
  input wire [63:0] target,
  input wire [15:0] work_from,
  input wire [15:0] result,
  input wire [31:0] first_move,        // distance in bits 0 to 15, number of words from bit 16 on
  input wire [31:0] second_move,
  input wire [2:0] operation,
  input wire [15:0] work_bits,
  input wire [5:0] opcode,
  input wire [15:0] linear_width,
  input wire [15:0] linear_shift,
  input wire [31:0] constant,
  output wire [CONTROL_BITS-1:0] control,
  output wire [PORTS*WORD_BITS-1:0] constant_words
);
`include "cell_control.vh"
`include "opcodes.vh"
  localparam [1:0] KIND_CLEAR = 1, KIND_INSTRUCTION = 2, KIND_MARK = 3;
  localparam [15:0] WORD = WORD_BITS[15:0];
  localparam [15:0] EACH = PORTS[15:0];
  localparam [15:0] TAKES = LANES[15:0];
  localparam [15:0] SHIFTS = STEP[15:0];
  localparam [15:0] KEPT = F_WORDS[15:0];
  localparam [15:0] ALL_WORDS = WORDS[15:0];
  localparam [15:0] LAST_BIT = WORD - 16'd1;

  wire [15:0] first_base = first_source[0 +: 16];
  wire [15:0] first_width = first_source[16 +: 16];
  wire [15:0] first_word = first_source[32 +: 16];
  wire [15:0] first_count = first_source[48 +: 16];
  wire [15:0] second_base = second_source[0 +: 16];
  wire [15:0] second_width = second_source[16 +: 16];
  wire [15:0] second_word = second_source[32 +: 16];
  wire [15:0] second_count = second_source[48 +: 16];
  wire [15:0] target_base = target[0 +: 16];
  wire [15:0] target_width = target[16 +: 16];
  wire [15:0] target_word = target[32 +: 16];
  wire [15:0] target_count = target[48 +: 16];

  wire clears = kind == KIND_CLEAR;
  wire is_instruction = kind == KIND_INSTRUCTION;
  wire is_mark = kind == KIND_MARK;
  wire is_first = number == 0;
  wire is_last = number + 16'd1 == beats;
  wire is_linear = linear_width != 0;
  wire is_root = opcode == ROOT;

  // Field with which the operands are aligned.
  wire has_target = target_width != 0;
  wire [15:0] met_base = has_target ? target_base : first_base;
  wire [15:0] met_width = has_target ? target_width : first_width;
  wire [15:0] place = has_target ? target_base - target_word * WORD : first_base - first_word * WORD;
  wire [15:0] first_place = first_base - first_word * WORD;
  wire [15:0] second_place = second_base - second_word * WORD;

  // Running sum.
  wire [15:0] fraction_words = linear_shift / WORD;
  wire [15:0] f_place = linear_shift - fraction_words * WORD;
  wire adds = is_instruction && is_linear && number < words;
  /* verilator lint_off UNUSEDSIGNAL */
  wire [15:0] f_word = number - fraction_words;
  wire [15:0] sign_place = (linear_width - 16'd1) % WORD;
  /* verilator lint_on UNUSEDSIGNAL */
  wire keeps = adds && number >= fraction_words && f_word < KEPT;

  // Work of the packet.
  wire works = is_instruction && number >= work_from && number <= result;
  wire starts = number == work_from;
  reg [1:0] move;
  reg [15:0] word;
  reg [15:0] moved;
  reg [15:0] taken;
  reg [15:0] root_bits;
  wire [1:0] move_now = starts ? 2'd0 : move;
  wire [15:0] word_now = starts ? 16'd0 : word;
  wire [15:0] moved_now = starts ? 16'd0 : moved;
  wire [15:0] taken_now = starts ? 16'd0 : taken;
  wire [15:0] root_bits_now = starts ? 16'd0 : root_bits;

  // Shifter.
  wire moves_first = move_now == 0 && first_move[0 +: 16] != 0;
  wire moves_second = !moves_first && move_now <= 1 && second_move[0 +: 16] != 0;
  wire moves = works && (moves_first || moves_second);
  wire [15:0] distance = moves_first ? first_move[0 +: 16] : second_move[0 +: 16];
  wire [15:0] move_words = moves_first ? first_move[16 +: 16] : second_move[16 +: 16];
  wire meets_first = first_base == met_base;   // the operands are aligned with the first field
  wire [1:0] moved_operand = moves_first && is_linear ? MOVE_F : moves_first && !meets_first ? MOVE_X : MOVE_Y;
  wire [15:0] moved_from = moved_operand == MOVE_F ? f_place : moved_operand == MOVE_X ? first_place : second_place;
  wire left = moved_from < place;
  wire [15:0] rest = distance - moved_now;
  wire is_moved = rest <= SHIFTS;
  wire all_moved = is_moved && word_now + 16'd1 == move_words;
  /* verilator lint_off UNUSEDSIGNAL */
  wire [15:0] amount = is_moved ? rest : SHIFTS;
  wire [15:0] move_word = left && !`CELL_FAULT(`FAULT_MOVE_ORDER) ? move_words - 16'd1 - word_now : word_now;
  /* verilator lint_on UNUSEDSIGNAL */

  // ALU, including a root's trials: bit k is tried with k + 3 bits, starting at bit 2 * (bits - 1 - k).
  wire tries = works && is_root;
  wire takes = works && !moves && !is_root && taken_now < work_bits;
  wire [15:0] trial_bits = root_bits_now + 16'd3;
  wire [15:0] trial_place = place + ((target_width >> 1) - 16'd1 - root_bits_now) * 16'd2;
  wire [15:0] left_over = (tries ? trial_bits : work_bits) - taken_now;
  wire [15:0] count = left_over < TAKES ? left_over : TAKES;
  wire [15:0] from = (tries ? trial_place : place) + taken_now;
  wire is_tried = count == left_over;
  wire [15:0] in_field = met_width > taken_now ? met_width - taken_now : 16'd0;
  /* verilator lint_off UNUSEDSIGNAL */
  wire [15:0] meeting = in_field < count ? in_field : count;
  wire [15:0] group = from / TAKES;
  wire [15:0] low = from % TAKES;
  wire [15:0] found_at = `CELL_FAULT(`FAULT_ROOT_PLACE) ? trial_place + 16'd1 : trial_place;
  /* verilator lint_on UNUSEDSIGNAL */
  wire keeps_value = opcode != LOAD_LINEAR && opcode != KEEP_MAX && opcode != KEEP_MIN && has_target;

  always @(posedge clk)
    if (reset) {move, word, moved, taken, root_bits} <= 66'd0;
    else if (works) begin
      move <= moves && all_moved ? (moves_first ? 2'd1 : 2'd2) : moves_second ? 2'd1 : move_now;
      word <= !moves || all_moved ? 16'd0 : is_moved ? word_now + 16'd1 : word_now;
      moved <= moves && !is_moved ? moved_now + SHIFTS : 16'd0;
      taken <= tries && is_tried ? 16'd0 : tries || takes ? taken_now + count : taken_now;
      root_bits <= tries && is_tried ? root_bits_now + 16'd1 : root_bits_now;
    end

  assign control[CC_FIRST] = is_first && (is_instruction || is_mark);
  assign control[CC_FRESH] = is_first && begins_line && (is_instruction || is_mark);
  assign control[CC_CLEAR] = clears;
  assign control[CC_DISABLE] = clears && is_last;
  assign control[CC_HOLD] = is_mark && is_last;
  assign control[CC_ADD] = adds;
  assign control[CC_KEEP] = keeps;
  assign control[CC_F_WORD +: INDEX] = f_word[0 +: INDEX];
  assign control[CC_ACT] = is_instruction && number == result;
  assign control[CC_OPCODE +: 6] = is_instruction ? opcode : 6'd0;
  assign control[CC_MOVE] = moves;
  assign control[CC_MOVE_OPERAND +: 2] = moved_operand;
  assign control[CC_MOVE_LEFT] = left;
  assign control[CC_MOVE_WORD +: INDEX] = move_word[0 +: INDEX];
  assign control[CC_MOVE_AMOUNT +: AMOUNT] = amount[0 +: AMOUNT];
  assign control[CC_MOVED +: BIT] = moved_now[0 +: BIT];
  assign control[CC_MOVE_LAST] = all_moved && !left;
  assign control[CC_WORK] = takes;
  assign control[CC_BEGIN] = tries ? starts : taken_now == 0;
  assign control[CC_LINEAR] = is_linear;
  assign control[CC_FUNCTION +: 3] = operation;
  assign control[CC_STORE] = tries || (takes && keeps_value);
  assign control[CC_GROUP +: GROUP] = group[0 +: GROUP];
  assign control[CC_LOW +: LANE] = low[0 +: LANE];
  assign control[CC_COUNT +: COUNT] = count[0 +: COUNT];
  assign control[CC_MEETING +: COUNT] = meeting[0 +: COUNT];
  assign control[CC_TRY] = tries;
  assign control[CC_TRY_FIRST] = taken_now == 0;
  assign control[CC_TRY_SECOND] = taken_now <= 1 && taken_now + count > 1;
  assign control[CC_TRY_LAST] = is_tried;
  assign control[CC_TRY_PLACE +: PLACE] = found_at[0 +: PLACE];
  assign control[CC_CONSTANT] = opcode == SET_CONSTANT || is_mark && background;

  // Words of a constant are aligned like those of the field.
  wire [15:0] constant_place = is_mark ? 16'd0 : place;
  wire [95:0] constant_there = {64'd0, constant} << constant_place;
  genvar p;
  generate
    for (p = 0; p < PORTS; p = p + 1) begin : port
      localparam [15:0] HERE = p[15:0];
      // Reads.
      wire [15:0] r = number * EACH + HERE;
      wire is_of_first = r < first_count;
      wire reads = (is_instruction || is_mark) && r < first_count + second_count;
      wire [15:0] read_index = is_of_first ? r : r - first_count;
      wire [15:0] read_address = read_index + (is_of_first ? first_word : second_word);
      wire [15:0] read_end = (is_of_first ? first_base + first_width : second_base + second_width) - {15'd0, is_root};
      // Writes, and the constant's words if these are only written or held.
      wire [15:0] w = (number - result) * EACH + HERE;
      wire writes = is_instruction && number >= result && w < target_count;
      wire sets = writes && opcode == SET_CONSTANT;
      wire fills = is_mark && background && r < words;
      wire wipes = clears && CLEARS_AT_ONCE == 0 && r < ALL_WORDS;
      wire [15:0] index = fills ? r : writes ? w : read_index;
      wire [15:0] address = wipes ? r : writes ? w + target_word : read_address;
      wire [15:0] ends = writes ? target_base + target_width : read_end;
      wire is_whole = wipes || fills;
      /* verilator lint_off UNUSEDSIGNAL */
      wire [15:0] lowest = is_whole || index != 0 ? 16'd0 : writes ? place : is_of_first ? first_place : second_place;
      /* verilator lint_on UNUSEDSIGNAL */
      wire is_topmost = !is_whole && ends <= (address + 16'd1) * WORD;
      wire is_empty = ends <= address * WORD;   // the topmost bit of a root's field is not read
      /* verilator lint_off UNUSEDSIGNAL */
      wire [15:0] highest = !reads && !writes && !is_whole ? sign_place : is_topmost ? ends - 16'd1 - address * WORD : LAST_BIT;
      wire [95:0] constant_word = constant_there >> (`CELL_FAULT(`FAULT_CONSTANT) ? 16'd0 : index * WORD);
      /* verilator lint_on UNUSEDSIGNAL */
      wire is_read = reads && !is_empty;
      assign control[CC_PORT + p*PORT_BITS +: PORT_BITS] = {
        highest[0 +: BIT], lowest[0 +: BIT], address[0 +: ADDRESS], index[0 +: INDEX], writes || wipes,
        (is_read && !is_of_first) || (is_read && opcode == XOR_CONSTANT), (is_read && is_of_first) || sets || fills};
      assign constant_words[p*WORD_BITS +: WORD_BITS] = constant_word[0 +: WORD_BITS];
    end
  endgenerate
endmodule
