// The FIFO neither loses nor invents words: an arbitrary incoming word is marked, and its place in the queue is
// tracked. It comes out unchanged after the words ahead of it, unless it was dropped. The FIFO offers a word exactly
// when it holds one, and has room exactly when it holds fewer than its places. Assumption: no word is taken from an
// empty FIFO.
module fifo_check #(
  parameter DEPTH = 4,
  parameter BITS = 3
) (
  input wire clk,
  input wire reset,
  input wire drop,
  input wire [BITS-1:0] in,
  input wire in_valid,
  input wire take,
  input wire mark  // selects this word, if none is tracked yet
);
  localparam COUNT = $clog2(DEPTH + 1) + 1;
  wire in_ready, out_valid;
  wire [BITS-1:0] out;
  fifo #(.DEPTH(DEPTH), .BITS(BITS)) dut (
    .clk(clk), .reset(reset), .drop(drop), .in(in), .in_valid(in_valid), .in_ready(in_ready), .out(out),
    .out_valid(out_valid), .take(take));

  reg begun = 1'b0;
  reg [COUNT-1:0] held;    // words in the FIFO
  reg followed;
  reg [COUNT-1:0] before;  // words ahead of the tracked one
  reg [BITS-1:0] value;
  wire push = in_valid & in_ready;
  wire [COUNT-1:0] left = drop ? 0 : held - take;
  always @(posedge clk) begin
    begun <= 1'b1;
    if (reset) begin
      held <= 0;
      followed <= 1'b0;
    end else begin
      held <= left + push;
      if (followed && (drop || take && before == 0)) followed <= 1'b0;
      if (followed && take) before <= before - 1'b1;
      if (push && mark && !followed) begin
        followed <= 1'b1;
        before <= left;
        value <= in;
      end
    end
  end

  // The positions of its words make the induction one step long. DEPTH is at most 4 here.
  localparam PLACE = DEPTH > 1 ? $clog2(DEPTH) : 1;
  (* hierconn *) wire [PLACE-1:0] \dut.first ;
  (* hierconn *) wire [PLACE-1:0] \dut.last ;
  (* hierconn *) wire [$clog2(DEPTH+1)-1:0] \dut.count ;
  (* hierconn *) wire [BITS-1:0] \dut.words[0] ;
  (* hierconn *) wire [BITS-1:0] \dut.words[1] ;
  (* hierconn *) wire [BITS-1:0] \dut.words[2] ;
  (* hierconn *) wire [BITS-1:0] \dut.words[3] ;
  wire [4*BITS-1:0] words = {\dut.words[3] , \dut.words[2] , \dut.words[1] , \dut.words[0] };
  wire [COUNT:0] behind_last = \dut.first + held;
  wire [COUNT:0] of_followed = \dut.first + before;
  wire [COUNT:0] place_of_followed = of_followed >= DEPTH ? of_followed - DEPTH : of_followed;

  always @* begin
    assume (reset == !begun);
    assume (!take || out_valid);
    if (begun) begin
      assert (out_valid == (held != 0));
      assert (in_ready == (held != DEPTH));
      assert (held <= DEPTH);
      assert (!followed || before < held);
      assert (!(followed && before == 0) || out == value);
      assert (\dut.count == held);
      assert (\dut.first < DEPTH);
      assert (\dut.last == (behind_last >= DEPTH ? behind_last - DEPTH : behind_last));
      assert (!followed || words[place_of_followed[1:0]*BITS +: BITS] == value);
    end
  end
endmodule
