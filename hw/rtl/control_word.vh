// The word that the controller broadcasts to every pixel each clock, from bit 0 up. Each comment gives the width in
// bits and the meaning; "per place" means one bit per place of the ALU. Needs the parameters ALU_BITS, ADDRESS (bits of
// an address of pixel memory) and SIDE (bits of a number of columns or rows).
//
// The ALU of a pixel is a ripple adder of ALU_BITS places (thesis 7.2.1: "logical operations and comparisons of values
// can be performed in the ALU by a one-bit adder"). At each place it adds p, q and a carry, where p is operand x,
// blanked and inverted per place, and q is operand y, blanked and inverted as a whole.

/* verilator lint_off UNUSEDPARAM */
localparam CW_X_SELECT = 0;                                // 2: source of operand x, see X_...
localparam CW_Y_ENABLE = CW_X_SELECT + 2;                  // 1: operand y is E; otherwise it is read from memory
localparam CW_Y_ZERO = CW_Y_ENABLE + 1;                    // 1: operand y is blanked
localparam CW_Y_INVERT = CW_Y_ZERO + 1;                    // 1: operand y is inverted
localparam CW_X_ZERO = CW_Y_INVERT + 1;                    // per place: operand x is blanked
localparam CW_X_INVERT = CW_X_ZERO + ALU_BITS;             // per place: operand x is inverted; with blanking, a
                                                           // constant
// Per place: takes part in the addition; the carry bypasses the other places.
localparam CW_ACTIVE = CW_X_INVERT + ALU_BITS;
localparam CW_CARRY_IN = CW_ACTIVE + ALU_BITS;             // 2: see CARRY_...
// 1: the carry ripples through the places; otherwise all places get the same carry.
localparam CW_RIPPLE = CW_CARRY_IN + 2;
localparam CW_SUM = CW_RIPPLE + 1;                         // 1: the result is the sum; otherwise the carry out
localparam CW_INVERT = CW_SUM + 1;                         // 1: the result for E or K is inverted
localparam CW_WRITE = CW_INVERT + 1;                       // 1: active places are written where E is 1
localparam CW_WRITE_ALL = CW_WRITE + 1;                    // 1: active places are written everywhere
localparam CW_WRITE_SELECTED = CW_WRITE_ALL + 1;           // 1: active places are written where E and K are 1
localparam CW_LATCH = CW_WRITE_SELECTED + 1;               // 1: active places of x are latched
localparam CW_SET_ENABLE = CW_LATCH + 1;                   // 1: E := result
localparam CW_AND_ENABLE = CW_SET_ENABLE + 1;              // 1: E := E and result
localparam CW_SET_CARRY = CW_AND_ENABLE + 1;               // 1: K := last carry
localparam CW_SELECT = CW_SET_CARRY + 1;                   // 1: K := E and result
localparam CW_STREAM = CW_SELECT + 1;                      // 1: a bit of F arrives with the word
localparam CW_QUESTION = CW_STREAM + 1;                    // 1: question: tests whether E is 1 at any pixel
localparam CW_CLEAR = CW_QUESTION + 1;                     // 1: clears registers, and CW_COUNT memory bits from CW_W on
localparam CW_X = CW_CLEAR + 1;                            // address of operand x, or of y with one read port
localparam CW_Y = CW_X + ADDRESS;                          // address of operand y
localparam CW_W = CW_Y + ADDRESS;                          // address to write, or the first to clear
localparam CW_COUNT = CW_W + ADDRESS;                      // number of memory bits to clear
// Number of columns of the segment, for a clear; pixels right of these take no part.
localparam CW_COLUMNS = CW_COUNT + ADDRESS + 1;
// Number of rows of the segment, for a clear; pixels below these take no part.
localparam CW_ROWS = CW_COLUMNS + SIDE;
localparam CW_X_BY_FLAG = CW_ROWS + SIDE;                  // 1: operand x is inverted where G is 0 (root subtraction)
localparam CW_SET_FLAG = CW_X_BY_FLAG + 1;                 // 1: G := inverted result
// 1: the scan-out latches the bit at address CW_X of row CW_ROWS.
localparam CW_REFRESH = CW_SET_FLAG + 1;
localparam CONTROL_BITS = CW_REFRESH + 1;

localparam X_TREE = 2'd0, X_LATCH = 2'd1, X_MEMORY = 2'd2, X_ENABLE = 2'd3;
localparam CARRY_ZERO = 2'd0, CARRY_ONE = 2'd1, CARRY_KEPT = 2'd2;
/* verilator lint_on UNUSEDPARAM */
