// The control word that passes from cell to cell with a beat, from bit 0 up. Each comment gives the width in bits and
// the meaning. Needs the parameters WORD_BITS, WORDS, PORTS, ALU_BITS, SHIFT_BITS and ROOTS.
//
// Operands have the same alignment to words as their fields in memory; F is aligned as it arrived, without whole words
// of fraction. Bit b of word w is bit w * WORD_BITS + b of the operand. The ALU processes LANES bits per clock,
// starting at any bit; it therefore reads two groups of LANES bits, the group in which they begin and the next.

/* verilator lint_off UNUSEDPARAM */
localparam LANES = ALU_BITS < WORD_BITS ? ALU_BITS : WORD_BITS;
localparam STEP = SHIFT_BITS < WORD_BITS ? SHIFT_BITS : WORD_BITS;
localparam F_WORDS = (2 * WORD_BITS + 60) / WORD_BITS;         // words that 62 bits can span
localparam SHORT_WORDS = (2 * WORD_BITS + 30) / WORD_BITS;     // words that 32 bits can span
localparam X_WORDS = WORDS < F_WORDS ? WORDS : F_WORDS;        // words of the first field, and of the value to write
localparam COLOUR_WORDS = WORDS < SHORT_WORDS ? WORDS : SHORT_WORDS;
localparam Y_WORDS = ROOTS != 0 ? X_WORDS : COLOUR_WORDS;      // words of the second field or of a partial root
localparam GROUPS = (F_WORDS * WORD_BITS + LANES - 1) / LANES;

localparam ADDRESS = WORDS > 1 ? $clog2(WORDS) : 1;
localparam INDEX = F_WORDS > 1 ? $clog2(F_WORDS) : 1;          // bits of a word index in an operand
localparam BIT = WORD_BITS > 1 ? $clog2(WORD_BITS) : 1;        // bits of a bit index in a word
localparam AMOUNT = $clog2(STEP + 1);
localparam GROUP = GROUPS > 1 ? $clog2(GROUPS) : 1;
localparam LANE = LANES > 1 ? $clog2(LANES) : 1;
localparam COUNT = $clog2(LANES + 1);
localparam PLACE = INDEX + BIT;                                // bits of a bit index in an operand

// Fields of all packets.
localparam CC_FIRST = 0;                                       // 1: first beat of a packet; nothing has been read
localparam CC_FRESH = CC_FIRST + 1;                            // 1: memory and E read as 0 in this clock
localparam CC_CLEAR = CC_FRESH + 1;                            // 1: ports write 0
localparam CC_DISABLE = CC_CLEAR + 1;                          // 1: E := 0
localparam CC_HOLD = CC_DISABLE + 1;                           // 1: the hold register stores the words read
// Fields of the running sum.
localparam CC_ADD = CC_HOLD + 1;                               // 1: words of F and A arrive
localparam CC_KEEP = CC_ADD + 1;                               // 1: the word of F is kept
localparam CC_F_WORD = CC_KEEP + 1;                            // at this word index
// Fields of the instruction's result.
localparam CC_ACT = CC_F_WORD + INDEX;                         // 1: clock of the result
localparam CC_OPCODE = CC_ACT + 1;                             // 6: as in hw/isa/opcodes.h
// Fields of the shifter.
localparam CC_MOVE = CC_OPCODE + 6;                            // 1: a word is shifted
localparam CC_MOVE_OPERAND = CC_MOVE + 1;                      // 2: operand F, x or y, see MOVE_...
localparam CC_MOVE_LEFT = CC_MOVE_OPERAND + 2;                 // 1: towards higher bits
localparam CC_MOVE_WORD = CC_MOVE_LEFT + 1;                    // index of the word
localparam CC_MOVE_AMOUNT = CC_MOVE_WORD + INDEX;              // number of bits to shift
localparam CC_MOVED = CC_MOVE_AMOUNT + AMOUNT;                 // number of bits shifted in earlier clocks
localparam CC_MOVE_LAST = CC_MOVED + BIT;                      // 1: the word above is cleared
// Fields of the ALU.
localparam CC_WORK = CC_MOVE_LAST + 1;                         // 1: the ALU processes bits
localparam CC_BEGIN = CC_WORK + 1;                             // 1: first bits of the operands
localparam CC_LINEAR = CC_BEGIN + 1;                           // 1: operands F and x; otherwise x and y
localparam CC_FUNCTION = CC_LINEAR + 1;                        // 3: see ALU_...
localparam CC_STORE = CC_FUNCTION + 3;                         // 1: the value replaces x
localparam CC_GROUP = CC_STORE + 1;                            // group in which the bits begin
localparam CC_LOW = CC_GROUP + GROUP;                          // first bit within the group
localparam CC_COUNT = CC_LOW + LANE;                           // number of bits
localparam CC_MEETING = CC_COUNT + COUNT;                       // number of the CC_COUNT bits that are within the field
// Fields of root trials.
localparam CC_TRY = CC_MEETING + COUNT;                         // 1: the ALU tries a bit of a root
localparam CC_TRY_FIRST = CC_TRY + 1;                          // 1: the bits include bit 0 of the trial
localparam CC_TRY_SECOND = CC_TRY_FIRST + 1;                   // 1: the bits include bit 1
localparam CC_TRY_LAST = CC_TRY_SECOND + 1;                    // 1: the bits include the sign
localparam CC_TRY_PLACE = CC_TRY_LAST + 1;                     // position of the trial's bit 0 in the operand
// Fields of each port.
localparam CC_CONSTANT = CC_TRY_PLACE + PLACE;                 // 1: words of x come from the constant, not from memory
localparam CC_PORT = CC_CONSTANT + 1;
localparam PORT_X = 0;                                         // 1: reads a word of x
localparam PORT_Y = 1;                                         // 1: reads a word of y; with PORT_X, of the constant
localparam PORT_WRITE = 2;                                     // 1: writes a word
localparam PORT_INDEX = 3;                                     // index of the word in its operand
localparam PORT_ADDRESS = PORT_INDEX + INDEX;                  // address of the word in memory
localparam PORT_LOW = PORT_ADDRESS + ADDRESS;                  // lowest bit read or written
// Highest bit read or written; at port 0, in a test of F's sign, the position of the sign.
localparam PORT_HIGH = PORT_LOW + BIT;
localparam PORT_BITS = PORT_HIGH + BIT;
localparam CONTROL_BITS = CC_PORT + PORTS * PORT_BITS;

localparam MOVE_F = 2'd0, MOVE_X = 2'd1, MOVE_Y = 2'd2;
localparam ALU_NONE = 3'd0, ALU_ADD = 3'd1, ALU_SUBTRACT = 3'd2, ALU_AND = 3'd3, ALU_OR = 3'd4, ALU_XOR = 3'd5,
  ALU_AND_NOT = 3'd6, ALU_NOT = 3'd7;
/* verilator lint_on UNUSEDPARAM */
