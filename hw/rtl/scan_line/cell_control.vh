// The control word that goes from cell to cell with a beat, from bit 0 up. Needs the parameters WORD_BITS, WORDS, PORTS,
// ALU_BITS, SHIFT_BITS and ROOTS.
//
// Operands lie in words as their fields do in memory, F as it came in but for whole words of fraction: bit b of word w is
// bit w * WORD_BITS + b of the operand. The ALU takes LANES bits a clock from any bit on: so it stands between two groups of
// LANES bits, the one in which they begin and the next.

/* verilator lint_off UNUSEDPARAM */
localparam LANES = ALU_BITS < WORD_BITS ? ALU_BITS : WORD_BITS;
localparam STEP = SHIFT_BITS < WORD_BITS ? SHIFT_BITS : WORD_BITS;
localparam F_WORDS = (2 * WORD_BITS + 60) / WORD_BITS;         // that 62 bits can touch
localparam SHORT_WORDS = (2 * WORD_BITS + 30) / WORD_BITS;     // that 32 bits can touch
localparam X_WORDS = WORDS < F_WORDS ? WORDS : F_WORDS;        // of the first field read, and of what is written
localparam COLOUR_WORDS = WORDS < SHORT_WORDS ? WORDS : SHORT_WORDS;
localparam Y_WORDS = ROOTS != 0 ? X_WORDS : COLOUR_WORDS;      // of the second; of a root as it is found
localparam GROUPS = (F_WORDS * WORD_BITS + LANES - 1) / LANES;

localparam ADDRESS = WORDS > 1 ? $clog2(WORDS) : 1;
localparam INDEX = F_WORDS > 1 ? $clog2(F_WORDS) : 1;          // of a word of an operand
localparam BIT = WORD_BITS > 1 ? $clog2(WORD_BITS) : 1;        // of a word
localparam AMOUNT = $clog2(STEP + 1);
localparam GROUP = GROUPS > 1 ? $clog2(GROUPS) : 1;
localparam LANE = LANES > 1 ? $clog2(LANES) : 1;
localparam COUNT = $clog2(LANES + 1);
localparam PLACE = INDEX + BIT;                                // of a bit of an operand

// All packets.
localparam CC_FIRST = 0;                                       // 1: a packet's first beat: nothing has been read
localparam CC_FRESH = CC_FIRST + 1;                            // 1: memory and E are 0 in this clock
localparam CC_CLEAR = CC_FRESH + 1;                            // 1: what ports write is 0
localparam CC_DISABLE = CC_CLEAR + 1;                          // 1: E becomes 0
localparam CC_HOLD = CC_DISABLE + 1;                           // 1: the hold register takes the words read
// The running sum.
localparam CC_ADD = CC_HOLD + 1;                               // 1: words of F and A come in
localparam CC_KEEP = CC_ADD + 1;                               // 1: F is kept as the word
localparam CC_F_WORD = CC_KEEP + 1;                            //    of this number
// The instruction's result.
localparam CC_ACT = CC_F_WORD + INDEX;                         // 1: the clock of the result
localparam CC_OPCODE = CC_ACT + 1;                             // 6: as in hw/isa/opcodes.h
// The shifter.
localparam CC_MOVE = CC_OPCODE + 6;                            // 1: a word is moved
localparam CC_MOVE_OPERAND = CC_MOVE + 1;                      // 2: of F, x or y, see MOVE_...
localparam CC_MOVE_LEFT = CC_MOVE_OPERAND + 2;                 // 1: towards higher bits
localparam CC_MOVE_WORD = CC_MOVE_LEFT + 1;                    // its number
localparam CC_MOVE_AMOUNT = CC_MOVE_WORD + INDEX;              // by so many bits
localparam CC_MOVED = CC_MOVE_AMOUNT + AMOUNT;                 // after so many in the clocks before
localparam CC_MOVE_LAST = CC_MOVED + BIT;                      // 1: nothing is left above it
// The ALU.
localparam CC_WORK = CC_MOVE_LAST + 1;                         // 1: it takes bits
localparam CC_BEGIN = CC_WORK + 1;                             // 1: the first
localparam CC_LINEAR = CC_BEGIN + 1;                           // 1: of F and x; else of x and y
localparam CC_FUNCTION = CC_LINEAR + 1;                        // 3: see ALU_...
localparam CC_STORE = CC_FUNCTION + 3;                         // 1: the value takes the place of x
localparam CC_GROUP = CC_STORE + 1;                            // they begin in this group
localparam CC_LOW = CC_GROUP + GROUP;                          // at this bit of it
localparam CC_COUNT = CC_LOW + LANE;                           // so many
localparam CC_MEETING = CC_COUNT + COUNT;                       // of which so many meet the field
// Roots.
localparam CC_TRY = CC_MEETING + COUNT;                         // 1: the ALU tries a bit of a root
localparam CC_TRY_FIRST = CC_TRY + 1;                          // 1: bit 0 of the trial is among those taken
localparam CC_TRY_SECOND = CC_TRY_FIRST + 1;                   // 1: bit 1 is
localparam CC_TRY_LAST = CC_TRY_SECOND + 1;                    // 1: its sign is
localparam CC_TRY_PLACE = CC_TRY_LAST + 1;                     // of the trial's bit 0 in the operand
// Each port.
localparam CC_CONSTANT = CC_TRY_PLACE + PLACE;                 // 1: words of x are those of the constant, not of memory
localparam CC_PORT = CC_CONSTANT + 1;
localparam PORT_X = 0;                                         // 1: a word of x is read
localparam PORT_Y = 1;                                         // 1: or of y; of both, that of y is the constant's
localparam PORT_WRITE = 2;                                     // 1: a word is written
localparam PORT_INDEX = 3;                                     // number of the word in its operand
localparam PORT_ADDRESS = PORT_INDEX + INDEX;                  // and in memory
localparam PORT_LOW = PORT_ADDRESS + ADDRESS;                  // its lowest bit that is read or written
localparam PORT_HIGH = PORT_LOW + BIT;                         // and its highest; at port 0 the sign of F, where it is tested
localparam PORT_BITS = PORT_HIGH + BIT;
localparam CONTROL_BITS = CC_PORT + PORTS * PORT_BITS;

localparam MOVE_F = 2'd0, MOVE_X = 2'd1, MOVE_Y = 2'd2;
localparam ALU_NONE = 3'd0, ALU_ADD = 3'd1, ALU_SUBTRACT = 3'd2, ALU_AND = 3'd3, ALU_OR = 3'd4, ALU_XOR = 3'd5,
  ALU_AND_NOT = 3'd6, ALU_NOT = 3'd7;
/* verilator lint_on UNUSEDPARAM */
