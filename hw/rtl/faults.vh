// Planted faults. A build with CSGSIM_PLANTED_FAULTS has the one whose number is on the wires `fault` of the top module; 0
// is none.
`ifdef CSGSIM_PLANTED_FAULTS
`define FAULT(NUMBER) (pixel_planes.fault == NUMBER)
`else
`define FAULT(NUMBER) 1'b0
`endif

`define FAULT_ALU_FUNCTION 1        // the sum of the adder forgets its carry
`define FAULT_CARRY 2               // a kept carry is taken for 0
`define FAULT_ENABLE 3              // enable is not held back by what it was
`define FAULT_SECOND_READ 4         // the latch is loaded only where enabled; the second port reads what the first does
`define FAULT_MEMORY_WRITE 5        // the topmost memory bit cannot be written
`define FAULT_TREE_ADDER 6          // carries of the trees start where the stream before ended
`define FAULT_TREE_DELAY 7          // B, or the coefficient of y * y, enters the Y tree too early
`define FAULT_TREE_SELECT 8         // the multiplicand counts while its wire has that of the instruction before
`define FAULT_DECODE 9              // field_le is taken for field_lt
`define FAULT_CLEAR 10              // the last word of a clear clears a bit less
`define FAULT_QUESTION 11           // the OR misses the lower half of the picture
`define FAULT_SKIP 12               // a jump goes an instruction too far
`define FAULT_REGION 13             // pixels right of a segment take part
`define FAULT_FLAG 14               // a root always subtracts
`define FAULT_DIFFERENCE 15         // linear_minus begins without a carry
`define FAULT_SLOPE_DELAY 16        // a node's delayed slope counts while it is that of the stream before
`define FAULT_SQUARE_SELECT 17      // the coefficient of a square counts while its wire has that of the stream before
`define FAULT_SHOWN_ROW 18          // at a port of its own the scan-out reads a row's first bit from the row before
`define FAULT_REFRESH_ROW 19        // refresh words for the last row name the one below
`define FAULT_SCAN_LATE 20          // the bit that arrives as a row is shifted is lost
`define FAULT_HOLD 21               // a picture is copied while the one before is still being latched
`define FAULT_COPY 22               // a copy inverts
`define FAULT_CLEAR_LIMIT 23        // a clear takes what is still to be latched
`define FAULT_DROP 24               // a jump leaves in the FIFO what it holds
`define FAULT_CONSTANT 25           // a command is taken for whole without its constant
`define FAULT_BANK 26               // bits that lie a word on are looked for in the word before
`define FAULT_COUNT 27              // clocks after a jump are counted as those of a starved controller
