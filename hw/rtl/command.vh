// Positions of the fields of a command (docs/instruction-set.md, "On a link"), and the numbers of commands.
/* verilator lint_off UNUSEDPARAM */
localparam COMMAND_BITS = 222;  // longest command: 18 + 18 + 3 * 62 bits
localparam SQUARES_BITS = 186;  // coefficients of squares: 3 * 62 bits

localparam ENABLE_ALL = 6'd0, ENABLE_INVERT = 6'd1, ENABLE_LOAD = 6'd2, ENABLE_AND = 6'd3, ENABLE_AND_NOT = 6'd4,
           ENABLE_OR = 6'd5, ENABLE_XOR = 6'd6, ENABLE_STORE = 6'd7, EDGE_NOT_NEGATIVE = 6'd8, EDGE_NEGATIVE = 6'd9,
           LINEAR_GE = 6'd10, LINEAR_GT = 6'd11, LINEAR_LE = 6'd12, LINEAR_LT = 6'd13, LINEAR_EQ = 6'd14,
           LOAD_LINEAR = 6'd15, KEEP_MAX = 6'd16, KEEP_MIN = 6'd17, SET_CONSTANT = 6'd18, COPY = 6'd19, FIELD_LT = 6'd20,
           FIELD_LE = 6'd21, FIELD_EQ = 6'd22, BIT_AND = 6'd23, BIT_OR = 6'd24, BIT_XOR = 6'd25, BIT_AND_NOT = 6'd26,
           BIT_NOT = 6'd27, GLOBAL_OR = 6'd28, XOR_CONSTANT = 6'd29, SKIP_IF_NONE = 6'd30, ADD = 6'd31, STRIPE = 6'd32,
           SQUARES = 6'd33, LINEAR_PLUS = 6'd34, LINEAR_MINUS = 6'd35, ROOT = 6'd36,
           SEGMENT = 6'd61, SEGMENT_END = 6'd62, FRAME_END = 6'd63;

localparam FIELD_0 = 6, FIELD_1 = 24, FIELD_2 = 42;  // 12 bits of base, 6 of width
localparam BASE_BITS = 12;
/* verilator lint_on UNUSEDPARAM */
