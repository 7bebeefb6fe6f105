// Planted faults. A build with CSGSIM_PLANTED_FAULTS activates the fault whose number is on the wires `fault` of the
// top module; 0 activates none.
`ifdef CSGSIM_PLANTED_FAULTS
`define FAULT(NUMBER) (pixel_planes.fault == NUMBER)
`else
`define FAULT(NUMBER) 1'b0
`endif

`define FAULT_ALU_FUNCTION 1        // the adder's sum ignores its carry
`define FAULT_CARRY 2               // a kept carry is read as 0
`define FAULT_ENABLE 3              // a new enable bit is not masked by the old one
// The latch is loaded only where E is 1; the second port reads the same data as the first.
`define FAULT_SECOND_READ 4
`define FAULT_MEMORY_WRITE 5        // the topmost memory bit cannot be written
`define FAULT_TREE_ADDER 6          // carries of the trees start with the last carries of the previous stream
`define FAULT_TREE_DELAY 7          // B, or the coefficient of y * y, enters the Y tree too early
// The multiplicand is used while its wire still carries that of the previous instruction.
`define FAULT_TREE_SELECT 8
`define FAULT_DECODE 9              // field_le is decoded as field_lt
`define FAULT_CLEAR 10              // the last word of a clear clears one bit too few
`define FAULT_QUESTION 11           // the OR ignores the lower half of the picture
`define FAULT_SKIP 12               // a jump goes one instruction too far
`define FAULT_REGION 13             // pixels right of a segment take part
`define FAULT_FLAG 14               // a root always subtracts
`define FAULT_DIFFERENCE 15         // linear_minus starts without a carry
`define FAULT_SLOPE_DELAY 16        // a node uses its delayed slope while that still belongs to the previous stream
// The coefficient of a square is used while its wire still carries that of the previous stream.
`define FAULT_SQUARE_SELECT 17
`define FAULT_SHOWN_ROW 18          // with a separate port, the scan-out reads a row's first bit from the previous row
`define FAULT_REFRESH_ROW 19        // refresh words for the last row address the row below
`define FAULT_SCAN_LATE 20          // the bit that arrives while a row is shifted is lost
`define FAULT_HOLD 21               // a picture is copied while the previous one is still being latched
`define FAULT_COPY 22               // a copy inverts the bits
`define FAULT_CLEAR_LIMIT 23        // a clear overwrites bits that have not been latched
`define FAULT_DROP 24               // a jump does not empty the FIFO
`define FAULT_CONSTANT 25           // a command is treated as complete without its constant
`define FAULT_BANK 26               // bits in the next word are read from the previous word
`define FAULT_COUNT 27              // clocks after a jump are counted as starved
