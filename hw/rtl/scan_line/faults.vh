// Planted faults. A build with CSGSIM_PLANTED_FAULTS has the one whose number is on the wires `fault` of cell_chain; 0 is
// none.
`ifdef CSGSIM_PLANTED_FAULTS
`define CELL_FAULT(NUMBER) (cell_chain.fault == NUMBER)
`else
`define CELL_FAULT(NUMBER) 1'b0
`endif

`define FAULT_SUM_CARRY 1           // a word of the running sum begins with the carry of the packet before
`define FAULT_WORD_CARRY 2          // the carry from word to word of the running sum is lost
`define FAULT_SECOND_DIFFERENCE 3   // the difference stays what it was
`define FAULT_READ_MASK 4           // a port reads the bit above the field, too
`define FAULT_WRITE_MASK 5          // a port does not write a word's topmost bit
`define FAULT_FRESH 6               // a line's first packet finds what the line before left
`define FAULT_CLEAR 7               // the last word of memory is not cleared
`define FAULT_X_KEPT 8              // x keeps what the packet before has read
`define FAULT_Y_WORD 9              // the second word of y comes to lie on the first
`define FAULT_F_WORD 10             // the last word of F is not kept
`define FAULT_SHIFT_BESIDE 11       // the bits beside the word that moves right do not come in
`define FAULT_SHIFT_LEFT 12         // those beside the word that moves left do not
`define FAULT_MOVE_ABOVE 13         // what a move leaves above y stays there
`define FAULT_ALU_CARRY 14          // a carry from clock to clock is lost
`define FAULT_ALU_DIFFERS 15        // only the last bits of a difference are looked at
`define FAULT_ALU_BEYOND 16         // bits of F above the field are not looked at
`define FAULT_ALU_STORE 17          // bits in the second group are not stored
`define FAULT_AND_NOT 18            // bit_and_not is taken for bit_and
`define FAULT_ENABLE 19             // enable_and_not does not hold back what was not enabled
`define FAULT_WRITES 20             // what is written after the clock of the result is written everywhere
`define FAULT_KEEP_MIN 21           // keep_min writes where F is equal
`define FAULT_HOLD 22               // colours are held only where enabled
`define FAULT_TRANSFER 23           // the shift chain takes the colours a clock too early
`define FAULT_SHIFT_CHAIN 24        // colours are inverted from cell to cell
`define FAULT_COLOUR_PLACE 25       // a line is shown from the place of the next line's colour
`define FAULT_MOVE_ORDER 26         // words that move left are moved from the lowest on
`define FAULT_CONSTANT 27           // a constant's second word is its first
`define FAULT_ALU_BEGIN 28          // the ALU begins a bit too low
`define FAULT_ROOT_SIGN 29          // a root always subtracts
`define FAULT_ROOT_PLACE 30         // bits of a root are found a place too high
`define FAULT_NEXT_GROUP 31         // the ALU's operands have 0 in the second group
`define FAULT_LAST_PORT 32          // what the last port reads does not come to the operands
`define FAULT_ROOT_STAYS 33         // a root does not move down behind a trial
`define FAULT_MOVE_WORD 34          // the second word of an operand stays where it is
`define FAULT_OR 35                 // the third of the words selected does not count
`define FAULT_HANDED_ON 36          // the difference is lost on the way to the third cell
