// Numbers of the instructions that a cell distinguishes, as in hw/isa/opcodes.h.
/* verilator lint_off UNUSEDPARAM */
localparam [5:0] ENABLE_ALL = 0, ENABLE_INVERT = 1, ENABLE_LOAD = 2, ENABLE_AND = 3, ENABLE_AND_NOT = 4, ENABLE_OR = 5,
  ENABLE_XOR = 6, ENABLE_STORE = 7, EDGE_NOT_NEGATIVE = 8, EDGE_NEGATIVE = 9, LINEAR_GE = 10, LINEAR_GT = 11, LINEAR_LE = 12,
  LINEAR_LT = 13, LINEAR_EQ = 14, LOAD_LINEAR = 15, KEEP_MAX = 16, KEEP_MIN = 17, SET_CONSTANT = 18, FIELD_LT = 20,
  FIELD_LE = 21, FIELD_EQ = 22, XOR_CONSTANT = 29, ADD = 31, STRIPE = 32, LINEAR_PLUS = 34, LINEAR_MINUS = 35, ROOT = 36;
/* verilator lint_on UNUSEDPARAM */
