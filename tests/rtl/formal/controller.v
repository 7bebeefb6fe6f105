// The controller never idles while it could proceed. In every state, either its input is missing (a frame, a whole
// command, an answer, the last row of the previous picture), or it sends a refresh word, or it leaves the state, or it
// comes closer to leaving it: instructions and copies in the order of their places, clears and the way to the pixels by
// counts. So it stays in none of these states for more clocks than a command has places, or memory bits, or tree
// levels. Assumptions: commands are valid, and `latched` occurs only after a picture. Refresh words may come first
// while the scan-out requests them, once for each bit of each row.
module controller_check #(
  parameter MEMORY_BITS = 9,
  parameter CLEAR_CLOCKS = 3,
  parameter LATENCY = 2,
  parameter MEMORY_READS = 1,
  parameter BUFFERS = 1,
  parameter LINK = 222
) (
  input wire clk,
  input wire reset,
  input wire frame,
  input wire [LINK-1:0] word,
  input wire word_valid,
  input wire answer_valid,
  input wire answer,
  input wire refresh,
  input wire take_picture,
  input wire latched
);
`include "command.vh"
`include "order.vh"
  localparam IDLE = 3'd0, READY = 3'd1, ISSUING = 3'd2, CLEARING = 3'd3, ANSWERING = 3'd4, HOLDING = 3'd5,
             COPYING = 3'd6, DRAINING = 3'd7;
  localparam ADDRESS = 4;
  localparam STEPS = $clog2(CLEAR_CLOCKS + 1) + 1;
  wire take_refresh;
  controller #(
    .MEMORY_BITS(MEMORY_BITS), .MEMORY_READS(MEMORY_READS), .LINK(LINK), .LATENCY(LATENCY), .CLEAR_CLOCKS(CLEAR_CLOCKS),
    .ADDRESS(ADDRESS), .SIDE(3), .BUFFERS(BUFFERS)
  ) dut (
    .clk(clk), .reset(reset), .frame(frame), .word(word), .word_valid(word_valid), .answer_valid(answer_valid),
    .answer(answer), .refresh(refresh), .take_refresh(take_refresh), .refresh_address(4'd0), .refresh_row(3'd0),
    .take_picture(take_picture), .latched(latched));

  (* hierconn *) wire [2:0] \dut.state ;
  (* hierconn *) wire [5:0] \dut.at ;
  (* hierconn *) wire \dut.pass ;
  (* hierconn *) wire [5:0] \dut.turn ;
  (* hierconn *) wire [COMMAND_BITS-1:0] \dut.current ;
  (* hierconn *) wire [COMMAND_BITS-1:0] \dut.received ;
  (* hierconn *) wire [5:0] \dut.colour_width ;
  (* hierconn *) wire [7:0] \dut.drained ;
  (* hierconn *) wire \dut.whole ;
  (* hierconn *) wire \dut.take ;
  (* hierconn *) wire \dut.unlatched ;
  (* hierconn *) wire [STEPS-1:0] \dut.clears.step ;

  wire [5:0] number = \dut.received [5:0];
  wire is_command = is_valid(\dut.received [41:0]) || number >= SEGMENT;
  wire [12:0] place = order_of(\dut.current [5:0], \dut.turn , \dut.at , \dut.pass );

  wire [6:0] copied = {\dut.at , \dut.pass };

  reg begun = 1'b0;
  reg [2:0] was;
  reg [12:0] was_place;
  reg [6:0] was_copied;
  reg [7:0] was_drained;
  reg [STEPS-1:0] was_step;
  reg was_refreshing, was_waiting, took;
  always @(posedge clk) begin
    begun <= 1'b1;
    was <= reset ? IDLE : \dut.state ;
    was_place <= place;
    was_copied <= copied;
    was_drained <= \dut.drained ;
    was_step <= \dut.clears.step ;
    was_refreshing <= take_refresh;
    took <= \dut.take ;
    case (\dut.state )
      IDLE: was_waiting <= !frame || \dut.unlatched && !latched;
      READY: was_waiting <= !\dut.whole ;
      ANSWERING: was_waiting <= !answer_valid;
      HOLDING: was_waiting <= \dut.unlatched && !latched;
      default: was_waiting <= 1'b0;
    endcase
    if (reset) was_waiting <= 1'b1;
  end

  wire stays = \dut.state == was;
  always @* begin
    assume (reset == !begun);
    assume (!\dut.whole || is_command);
    if (begun && !reset) begin
      // Possible states.
      if (\dut.state == ISSUING) begin
        assert (is_valid(\dut.current [41:0]) && !is_one_step(\dut.current [5:0]));
        assert (is_place(\dut.current [41:0], \dut.turn , \dut.at ));
      end
      if (\dut.state == CLEARING) assert (\dut.clears.step < CLEAR_CLOCKS);
      if (\dut.state == DRAINING) assert (\dut.drained <= LATENCY);
      if (\dut.state == HOLDING) assert (\dut.colour_width != 0);
      if (\dut.state == COPYING) assert (\dut.at < \dut.colour_width );
      if (BUFFERS == 1) assert (\dut.state != HOLDING && \dut.state != COPYING);
      // Progress within a state.
      if (stays) begin
        case (was)
          IDLE, HOLDING: begin
            assert (was_waiting);
          end
          ANSWERING: begin
            assert (was_waiting || took);
          end
          READY: begin
            assert (was_waiting || was_refreshing || took);
          end
          ISSUING: begin
            assert (place > was_place);
          end
          CLEARING: begin
            assert (\dut.clears.step > was_step);
          end
          COPYING: begin
            assert (copied > was_copied);
          end
          DRAINING: begin
            assert (\dut.drained > was_drained);
          end
        endcase
      end
    end
  end
endmodule
