// Planted faults. A build with CSGSIM_PLANTED_FAULTS activates the fault whose number is on the wires `fault` of
// cell_chain; 0 activates none.
`ifdef CSGSIM_PLANTED_FAULTS
`define CELL_FAULT(NUMBER) (cell_chain.fault == NUMBER)
`else
`define CELL_FAULT(NUMBER) 1'b0
`endif

`define FAULT_SUM_CARRY 1           // a word of the running sum starts with the carry of the previous packet
`define FAULT_WORD_CARRY 2          // the carry between words of the running sum is lost
`define FAULT_SECOND_DIFFERENCE 3   // the second difference is not added
`define FAULT_READ_MASK 4           // a port also reads the bit above the field
`define FAULT_WRITE_MASK 5          // a port does not write a word's topmost bit
`define FAULT_FRESH 6               // a line's first packet reads the previous line's data
`define FAULT_CLEAR 7               // the last word of memory is not cleared
`define FAULT_X_KEPT 8              // x keeps the words read by the previous packet
`define FAULT_Y_WORD 9              // the second word of y also overwrites the first
`define FAULT_F_WORD 10             // the last word of F is not kept
`define FAULT_SHIFT_BESIDE 11       // bits that come from the adjacent word in a right shift are lost
`define FAULT_SHIFT_LEFT 12         // bits that come from the adjacent word in a left shift are lost
`define FAULT_MOVE_ABOVE 13         // bits that a move leaves above y are not cleared
`define FAULT_ALU_CARRY 14          // the carry between clocks is lost
`define FAULT_ALU_DIFFERS 15        // only the last bits of a difference are compared
`define FAULT_ALU_BEYOND 16         // bits of F above the field are ignored
`define FAULT_ALU_STORE 17          // bits in the second group are not stored
`define FAULT_AND_NOT 18            // bit_and_not is executed as bit_and
`define FAULT_ENABLE 19             // enable_and_not does not exclude disabled cells
`define FAULT_WRITES 20             // words written after the clock of the result are written everywhere
`define FAULT_KEEP_MIN 21           // keep_min also writes where F is equal
`define FAULT_HOLD 22               // colours are held only where enabled
`define FAULT_TRANSFER 23           // the shift chain loads the colours one clock too early
`define FAULT_SHIFT_CHAIN 24        // colours are inverted at each cell
`define FAULT_COLOUR_PLACE 25       // a line is shown with the colour position of the next line
`define FAULT_MOVE_ORDER 26         // words shifted left are shifted in ascending order
`define FAULT_CONSTANT 27           // a constant's second word equals its first
`define FAULT_ALU_BEGIN 28          // the ALU starts one bit too low
`define FAULT_ROOT_SIGN 29          // a root always subtracts
`define FAULT_ROOT_PLACE 30         // bits of a root are stored one position too high
`define FAULT_NEXT_GROUP 31         // the ALU's operands are 0 in the second group
`define FAULT_LAST_PORT 32          // words read by the last port do not reach the operands
`define FAULT_ROOT_STAYS 33         // a root is not shifted down after a trial
`define FAULT_MOVE_WORD 34          // the second word of an operand is not shifted
`define FAULT_OR 35                 // the third selected word is ignored
`define FAULT_HANDED_ON 36          // the difference is lost on the way to the third cell
