// The controller: takes commands from the link, and puts bits of A, B and C and a control word for the pixels on the
// wires at each edge. Written from the instruction table (hw/isa/opcodes.h) and docs/machines/pixel-planes-4.md.
`include "faults.vh"

module controller #(
  parameter MEMORY_BITS = 72,
  parameter MEMORY_READS = 1,
  parameter ALU_BITS = 1,
  parameter LINK = 32,
  parameter LATENCY = 6,       // of the trees
  parameter CLEAR_CLOCKS = 1,  // 1 at least
  parameter ADDRESS = 7,
  parameter SIDE = 5
) (
  input wire clk,
  input wire reset,

  input wire frame,                        // the host has one
  output reg request,                      // of the words from an instruction on
  output reg [31:0] request_from,
  input wire [LINK-1:0] word,
  input wire word_valid,
  output wire take_word,
  output wire drop_words,

  output reg first,                        // the wires to the trees
  output reg a,
  output reg b,
  output reg c,
  output reg [CONTROL_BITS-1:0] control,   // and to the pixels
  input wire answer_valid,
  input wire answer,

  output reg told,                         // the host of an answer
  output reg told_any,
  output reg done,                         // with the frame
  output reg [31:0] clocks                 // of the frame, until it was done
);
`include "command.vh"
`include "control_word.vh"

  localparam IDLE = 3'd0, READY = 3'd1, ISSUING = 3'd2, CLEARING = 3'd3, ANSWERING = 3'd4, DRAINING = 3'd5;
  reg [2:0] state;
  reg [COMMAND_BITS-1:0] current;  // that is being carried out
  reg [5:0] at;
  reg pass;
  reg [5:0] turn;
  reg [31:0] next_instruction;
  reg drop_again;
  reg [7:0] drained;

  wire whole;
  wire [COMMAND_BITS-1:0] received;

  // What an answer does in the clock in which it is there.
  wire answered = state == ANSWERING && answer_valid;
  wire asks_skip = current[5:0] == SKIP_IF_NONE;
  wire jump = answered && asks_skip && !answer;
  assign drop_words = jump | drop_again;

  // A command begins at an edge at which nothing else has the control wires.
  wire free = state == READY || (answered && !jump);
  wire take = free && whole;
  wire [5:0] number = received[5:0];
  wire begins_instruction = take && number <= ROOT;
  wire begins_clear = take && number == SEGMENT;
  wire begins_drain = take && number == FRAME_END;

  receiver #(.LINK(LINK)) in (
    .clk(clk), .reset(reset), .drop(drop_words), .word(word), .word_valid(word_valid), .take_word(take_word),
    .whole(whole), .command(received), .take(take));

  wire [CONTROL_BITS-1:0] step_control;
  wire step_first, step_a, step_b, step_c, step_last, step_next_pass;
  wire [5:0] step_next_at;
  wire [5:0] step_next_turn;
  wire [COMMAND_BITS-1:0] command = begins_instruction ? received : current;
  sequencer #(.MEMORY_READS(MEMORY_READS), .ALU_BITS(ALU_BITS), .ADDRESS(ADDRESS), .SIDE(SIDE)) steps (
    .command(command), .at(begins_instruction ? 6'd0 : at), .pass(begins_instruction ? 1'b0 : pass),
    .turn(begins_instruction ? 6'd0 : turn),
    .control(step_control), .first(step_first), .a(step_a), .b(step_b), .c(step_c), .next_at(step_next_at),
    .next_pass(step_next_pass), .next_turn(step_next_turn), .last(step_last));

  wire [ADDRESS-1:0] clear_address;
  wire [ADDRESS:0] clear_count;
  wire clear_last;
  clearer #(.MEMORY_BITS(MEMORY_BITS), .CLOCKS(CLEAR_CLOCKS), .ADDRESS(ADDRESS)) clears (
    .clk(clk), .reset(reset), .begins(begins_clear), .goes_on(state == CLEARING),
    .address(clear_address), .count(clear_count), .last(clear_last));
  wire [COMMAND_BITS-1:0] segment = begins_clear ? received : current;

  wire issues = begins_instruction || state == ISSUING;
  wire is_clearing = begins_clear || state == CLEARING;
  wire asks = command[5:0] == GLOBAL_OR || command[5:0] == SKIP_IF_NONE;

  always @(posedge clk) begin
    request <= 1'b0;
    told <= 1'b0;
    done <= 1'b0;
    drop_again <= jump;
    control <= {CONTROL_BITS{1'b0}};
    {first, a, b, c} <= 4'b0000;
    if (state != IDLE) clocks <= clocks + 1;

    if (take) current <= received;
    if (begins_instruction) next_instruction <= next_instruction + 1;

    if (answered) begin
      state <= READY;
      told <= ~asks_skip;
      told_any <= answer;
    end
    if (jump) begin
      request <= 1'b1;
      request_from <= next_instruction + current[6 +: 32] + `FAULT(`FAULT_SKIP);
      next_instruction <= next_instruction + current[6 +: 32];
    end

    if (issues) begin
      control <= step_control;
      {first, a, b, c} <= {step_first, step_a, step_b, step_c};
      at <= step_next_at;
      pass <= step_next_pass;
      turn <= step_next_turn;
      state <= !step_last ? ISSUING : asks ? ANSWERING : READY;
    end
    if (is_clearing) begin
      control[CW_CLEAR] <= 1'b1;
      control[CW_W +: ADDRESS] <= clear_address;
      control[CW_COUNT +: ADDRESS + 1] <= clear_count;
      control[CW_COLUMNS +: SIDE] <= segment[6 + 32 +: SIDE];
      control[CW_ROWS +: SIDE] <= segment[6 + 48 +: SIDE];
      state <= clear_last ? READY : CLEARING;
    end

    // The frame is done when its last step has been carried out, LATENCY clocks after the edge at which this command
    // begins.
    if (begins_drain || state == DRAINING) begin
      drained <= (begins_drain ? 0 : drained) + 1;
      state <= DRAINING;
      if ((begins_drain ? 0 : drained) == LATENCY) begin
        state <= IDLE;
        done <= 1'b1;
      end
    end

    if (state == IDLE && frame) begin
      request <= 1'b1;
      request_from <= 0;
      next_instruction <= 0;
      clocks <= 0;
      state <= READY;
    end

    if (reset) begin
      state <= IDLE;
      request <= 1'b0;
      drop_again <= 1'b0;
      control <= {CONTROL_BITS{1'b0}};
      clocks <= 0;
    end
  end
endmodule
