// The controller: takes commands from the link, and puts coefficient bits and a control word for the pixels on the
// wires at each edge. Written from the instruction table (hw/isa/opcodes.h) and docs/machines/pixel-planes.md,
// "Controller", "Segments", "Global OR", "Scan-out" and "Buffers" (thesis 7.2.1).
//
// An instruction occupies the wires for its steps. A refresh word that the scan-out requests precedes the next command,
// and is sent whenever the controller waits. With two buffers, a finished picture is copied to the topmost bits as soon
// as the last row of the previous picture has been latched.
`include "faults.vh"

module controller #(
  parameter MEMORY_BITS = 72,
  parameter MEMORY_READS = 1,
  parameter ALU_BITS = 1,
  parameter DEGREE = 1,
  parameter LINK = 32,
  parameter LATENCY = 6,        // clocks from the wires to the pixels, at least 1
  parameter CLEAR_CLOCKS = 1,   // at least 1
  parameter SHOWS = 1,          // whether there is a scan-out
  parameter BUFFERS = 1,        // 1 or 2
  parameter ADDRESS = 7,
  parameter SIDE = 5
) (
  input wire clk,
  input wire reset,

  input wire frame,                        // the host has a frame
  output reg request,                      // requests the words from the instruction request_from on
  output reg [31:0] request_from,
  input wire [LINK-1:0] word,
  input wire word_valid,
  output wire take_word,
  output wire drop_words,

  input wire refresh,                      // the scan-out requests a refresh word
  input wire [ADDRESS-1:0] refresh_address,
  input wire [SIDE-1:0] refresh_row,
  output wire take_refresh,                // the refresh word is sent at this edge
  input wire latched,                      // the scan-out has latched the last row of a picture
  output reg picture,                      // a picture is ready for the scan-out
  output reg [11:0] picture_base,
  output reg [5:0] picture_width,
  input wire take_picture,

  output reg first,                        // wires to the trees, from here to yy
  output reg a,
  output reg b,
  output reg c,
  output reg xx,
  output reg xy,
  output reg yy,
  output reg [CONTROL_BITS-1:0] control,   // wires to the pixels
  input wire answer_valid,
  input wire answer,

  output reg told,                         // reports an answer to the host
  output reg told_any,                     // that answer: whether any pixel is enabled
  output reg done,                         // the frame is done
  output reg [31:0] clocks,                // clocks of the frame until it was done

  output reg [3:0] spent,                  // how the clock that begins is used: hw/rtl/spent.vh
  output reg refresh_waits                 // a refresh word was requested but not sent at the edge
);
`include "command.vh"
`include "control_word.vh"
`include "spent.vh"

  localparam IDLE = 3'd0, READY = 3'd1, ISSUING = 3'd2, CLEARING = 3'd3, ANSWERING = 3'd4, HOLDING = 3'd5,
             COPYING = 3'd6, DRAINING = 3'd7;
  localparam COPIES = BUFFERS > 1 && SHOWS;
  localparam [31:0] END = MEMORY_BITS;
  localparam [31:0] WAY = LATENCY;
  localparam [COMMAND_BITS-1:0] NOTHING = 0;
  reg [2:0] state;
  reg [COMMAND_BITS-1:0] current;  // command being executed
  reg [5:0] at;
  reg pass;
  reg [5:0] turn;
  reg [31:0] next_instruction;
  reg drop_again;
  reg jumped;                      // no command has arrived since the last jump
  reg [7:0] drained;
  reg unlatched;                   // some rows of the picture have not been latched

  wire whole;
  wire [COMMAND_BITS-1:0] received;

  // Actions in the clock in which an answer arrives.
  wire answered = state == ANSWERING && answer_valid;
  wire asks_skip = current[5:0] == SKIP_IF_NONE;
  wire jump = answered && asks_skip && !answer;
  assign drop_words = jump | drop_again;

  // A refresh word is sent when no command uses the control wires; a command begins when neither a command nor a
  // refresh word does.
  assign take_refresh = refresh && state != ISSUING && state != CLEARING && state != COPYING;
  wire shown_until_now = unlatched & ~latched;
  wire free = (state == READY || (answered && !jump)) && !take_refresh;
  wire take = free && whole;
  wire [5:0] number = received[5:0];
  wire begins_frame = state == IDLE && frame && (!shown_until_now || COPIES);
  wire begins_instruction = take && number <= ROOT;
  wire begins_clear = take && number == SEGMENT;
  wire ends_frame = take && number == FRAME_END;

  // End of a frame: the colours are copied first, unless there is only one buffer or nothing to show.
  reg [11:0] colour_base;
  reg [5:0] colour_width;
  wire begins_hold = COPIES && ends_frame && received[FIELD_0 + BASE_BITS +: 6] != 0;
  wire begins_copy = (begins_hold || state == HOLDING) && (!shown_until_now || `FAULT(`FAULT_HOLD));
  wire begins_drain = ends_frame && !begins_hold;
  wire drains = begins_drain || state == DRAINING;
  wire [7:0] drained_here = begins_drain ? 0 : drained;
  wire finishes = drains && drained_here == WAY[7:0];
  wire [11:0] copy_base = END[11:0] - {6'd0, colour_width};
  wire [11:0] shown_base = COPIES ? copy_base : colour_base;

  receiver #(.LINK(LINK)) in (
    .clk(clk), .reset(reset), .drop(drop_words), .word(word), .word_valid(word_valid), .take_word(take_word),
    .whole(whole), .command(received), .take(take));

  // Steps of an instruction or of a copy, which is enable_all followed by copy.
  wire begins_steps = begins_instruction | begins_copy;
  reg [COMMAND_BITS-1:0] command;
  always @* begin
    command = current;
    if (begins_instruction) command = received;
    if (begins_copy) command = NOTHING;
    if (state == COPYING) begin
      command = NOTHING;
      command[5:0] = `FAULT(`FAULT_COPY) ? BIT_NOT : COPY;
      command[FIELD_0 +: 12] = copy_base;
      command[FIELD_0 + BASE_BITS +: 6] = colour_width;
      command[FIELD_1 +: 12] = colour_base;
      command[FIELD_1 + BASE_BITS +: 6] = colour_width;
    end
  end

  wire [SQUARES_BITS-1:0] squares;
  wire [CONTROL_BITS-1:0] step_control;
  wire step_first, step_a, step_b, step_c, step_xx, step_xy, step_yy, step_last, step_next_pass;
  wire [5:0] step_next_at;
  wire [5:0] step_next_turn;
  sequencer #(
    .MEMORY_READS(MEMORY_READS), .ALU_BITS(ALU_BITS), .ADDRESS(ADDRESS), .SIDE(SIDE), .DEGREE(DEGREE)
  ) steps (
    .command(command), .squares(squares), .at(begins_steps ? 6'd0 : at), .pass(begins_steps ? 1'b0 : pass),
    .turn(begins_steps ? 6'd0 : turn), .control(step_control), .first(step_first), .a(step_a), .b(step_b), .c(step_c),
    .xx(step_xx), .xy(step_xy), .yy(step_yy), .next_at(step_next_at), .next_pass(step_next_pass),
    .next_turn(step_next_turn), .last(step_last));

  wire [ADDRESS-1:0] clear_address;
  wire [ADDRESS:0] clear_count;
  wire clear_last;
  wire [ADDRESS:0] clear_limit = shown_until_now && !`FAULT(`FAULT_CLEAR_LIMIT) ? {1'b0, picture_base[ADDRESS-1:0]}
                                                                                : END[ADDRESS:0];
  clearer #(.MEMORY_BITS(MEMORY_BITS), .CLOCKS(CLEAR_CLOCKS), .ADDRESS(ADDRESS)) clears (
    .clk(clk), .reset(reset), .begins(begins_clear), .goes_on(state == CLEARING), .limit(clear_limit),
    .address(clear_address), .count(clear_count), .last(clear_last));
  wire [SIDE-1:0] columns = begins_clear ? received[38 +: SIDE] : current[38 +: SIDE];
  wire [SIDE-1:0] rows = begins_clear ? received[54 +: SIDE] : current[54 +: SIDE];

  wire issues = begins_instruction || state == ISSUING;
  wire copies = begins_copy || state == COPYING;
  wire is_clearing = begins_clear || state == CLEARING;
  wire asks = command[5:0] == GLOBAL_OR || command[5:0] == SKIP_IF_NONE;
  wire [31:0] after_jump = next_instruction + current[6 +: 32];

  // Coefficients that an instruction `squares` stores for the next instruction.
  generate
    if (DEGREE > 1) begin : quadratic
      reg [SQUARES_BITS-1:0] kept;
      assign squares = kept;
      always @(posedge clk) begin
        if (reset) kept <= 0;
        else if (issues && step_last) kept <= command[5:0] == SQUARES ? command[12 +: SQUARES_BITS] : 0;
      end
    end else begin : linear
      assign squares = 0;
    end
  endgenerate

  always @(posedge clk) begin
    request <= 1'b0;
    told <= 1'b0;
    done <= 1'b0;
    drop_again <= jump;
    control <= {CONTROL_BITS{1'b0}};
    {first, a, b, c, xx, xy, yy} <= 7'b0000000;
    if (state != IDLE) clocks <= clocks + 1;
    if (latched) unlatched <= 1'b0;
    if (take_picture) picture <= 1'b0;

    if (take_refresh) begin
      control[CW_REFRESH] <= 1'b1;
      control[CW_X +: ADDRESS] <= refresh_address;
      control[CW_ROWS +: SIDE] <= refresh_row;
    end

    if (take) begin
      current <= received;
      jumped <= 1'b0;
    end
    if (begins_instruction) next_instruction <= next_instruction + 1;

    if (answered) begin
      state <= READY;
      told <= ~asks_skip;
      told_any <= answer;
    end
    if (jump) begin
      request <= 1'b1;
      request_from <= after_jump + (`FAULT(`FAULT_SKIP) ? 1 : 0);
      next_instruction <= after_jump;
      jumped <= 1'b1;
    end

    if (issues | copies) begin
      control <= step_control;
      {first, a, b, c, xx, xy, yy} <= {step_first, step_a, step_b, step_c, step_xx, step_xy, step_yy};
      at <= step_next_at;
      pass <= step_next_pass;
      turn <= step_next_turn;
    end
    if (issues) state <= !step_last ? ISSUING : asks ? ANSWERING : READY;
    if (is_clearing) begin
      control[CW_CLEAR] <= 1'b1;
      control[CW_W +: ADDRESS] <= clear_address;
      control[CW_COUNT +: ADDRESS + 1] <= clear_count;
      control[CW_COLUMNS +: SIDE] <= columns;
      control[CW_ROWS +: SIDE] <= rows;
      state <= clear_last ? READY : CLEARING;
    end

    if (ends_frame) begin
      colour_base <= received[FIELD_0 +: BASE_BITS];
      colour_width <= received[FIELD_0 + BASE_BITS +: 6];
    end
    if (begins_hold) state <= HOLDING;
    if (copies) begin
      state <= !begins_copy && step_last ? DRAINING : COPYING;
      if (begins_copy) at <= 0;
      drained <= 0;
    end

    // The frame is done when its last step has been executed: LATENCY clocks after the edge at which the command that
    // ends the frame begins, or after the last step of the copy.
    if (drains) begin
      drained <= drained_here + 1;
      state <= DRAINING;
    end
    if (finishes) begin
      state <= IDLE;
      done <= 1'b1;
      if (SHOWS && colour_width != 0) begin
        picture <= 1'b1;
        picture_base <= shown_base;
        picture_width <= colour_width;
        unlatched <= 1'b1;
      end
    end

    if (begins_frame) begin
      request <= 1'b1;
      request_from <= 0;
      next_instruction <= 0;
      clocks <= 0;
      jumped <= 1'b0;
      state <= READY;
    end

    if (reset) begin
      state <= IDLE;
      request <= 1'b0;
      drop_again <= 1'b0;
      picture <= 1'b0;
      unlatched <= 1'b0;
      control <= {CONTROL_BITS{1'b0}};
      clocks <= 0;
    end
  end

  // Outputs for counters.v.
  wire waits_for_command = begins_frame || ((state == READY || answered) && !begins_instruction && !begins_clear &&
                                            !ends_frame);
  wire after_jump_still = (jump || (jumped && !take && !begins_frame)) && !`FAULT(`FAULT_COUNT);
  always @(posedge clk) begin
    refresh_waits <= refresh & ~take_refresh & ~reset;
    if (issues) spent <= SPENT_ISSUING;
    else if (is_clearing) spent <= SPENT_CLEARING;
    else if (copies) spent <= SPENT_COPYING;
    else if (reset || finishes || (state == IDLE && !begins_frame)) spent <= SPENT_NONE;
    else if (take_refresh) spent <= SPENT_REFRESHING;
    else if (drains) spent <= SPENT_DRAINING;
    else if (begins_hold || state == HOLDING) spent <= SPENT_HOLDING;
    else if (waits_for_command) spent <= after_jump_still ? SPENT_JUMPING : SPENT_STARVED;
    else spent <= SPENT_ANSWERING;
  end
endmodule
