// What a clock of a frame is spent on: docs/machines/pixel-planes.md, "Where the clocks go".
/* verilator lint_off UNUSEDPARAM */
localparam SPENT_NONE = 4'd0, SPENT_ISSUING = 4'd1, SPENT_CLEARING = 4'd2, SPENT_STARVED = 4'd3, SPENT_ANSWERING = 4'd4,
           SPENT_JUMPING = 4'd5, SPENT_REFRESHING = 4'd6, SPENT_HOLDING = 4'd7, SPENT_COPYING = 4'd8,
           SPENT_DRAINING = 4'd9;
/* verilator lint_on UNUSEDPARAM */
