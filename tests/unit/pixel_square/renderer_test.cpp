// SystemC elaborates once per process, so ctest runs each case here in a separate process.

#include "hw/pixel_square/renderer.h"

#include "hw/isa/opcodes.h"
#include "hw/isa/wire.h"
#include "sim/reference/reference_array.h"
#include "tests/support/test.h"
#include "tests/unit/pixel_square/bench.h"

using namespace csgsim;
using namespace isa;
using namespace pixel_square;
using testing::Bench;

namespace {

// Every command takes one word of the link and is available before the first edge. The receiver takes SegmentStart at
// edge 1; from 2 on five clocks clear the memory; enable_all is issued at 7, the six bits of the linear expression at 8
// to 13, SegmentEnd at 14. A tree of 4 x 2 leaves has three levels, so the end arrives at 17.
constexpr std::uint32_t link_width = 256;
constexpr std::uint32_t clear_clocks = 5;
constexpr std::uint64_t drawn_at = 17;

// The header in words of 8 bits takes eight, and six colours of 4 bits take three.
constexpr std::uint32_t port_bits = 8;
constexpr std::uint64_t square_words = 8 + 3;

constexpr Field colour{2, 4};
constexpr isa::Region square{4, 2, 3, 2};
constexpr Instruction enable_all{.opcode = Opcode::enable_all};
constexpr Instruction ramp{
    .opcode = Opcode::load_linear, .fields = {colour}, .linear = {.a = 2, .b = 5, .c = 3, .width = 6}};

/// Records the reported instructions.
class Listener final : public systemc::RunListener {
 public:
  void after_instruction(const systemc::Retired& retired, const systemc::PixelView& /*pixels*/) override {
    instructions.push_back(retired);
  }
  void after_segment(std::uint32_t segment, const systemc::PixelView& /*pixels*/) override {
    squares.push_back(segment);
  }

  std::vector<systemc::Retired> instructions;
  std::vector<std::uint32_t> squares;
};

/// A renderer with 4 x 2 pixels and a link deep enough for all commands of a test.
struct Board {
  Board(std::uint32_t buffers, std::uint32_t move_bits, int port_depth)
      : Board({.buffers = buffers, .move_bits = move_bits, .port_bits = port_bits}, port_depth) {}

  Board(const pixel_square::Figures& figures, int port_depth)
      : machine(make_machine(figures)), bench(machine), colours("colours", port_depth), renderer("renderer", machine) {
    renderer.clock(bench.clock);
    renderer.link(link);
    renderer.colours(colours);
    renderer.finished(finished);
    renderer.retirement(retirement);
    retirement.begin(listener);
    names.begin(segments);
    renderer.begin(colour, names);
  }

  static machines::Machine make_machine(const pixel_square::Figures& figures) {
    machines::Machine machine = testing::square_machine(figures);
    machine.array = {4, 2, 8};
    machine.clear_clocks = clear_clocks;
    machine.link.width = link_width;
    return machine;
  }

  void send(const std::vector<Instruction>& instructions) {
    const auto put = [&](const isa::LinkWord& word) { CHECK(link.nb_write(word)); };
    isa::encode(isa::SegmentStart{square}, link_width, put);
    for (const Instruction& one : instructions) isa::encode(one, link_width, put);
    isa::encode(isa::SegmentEnd{}, link_width, put);
  }

  machines::Machine machine;
  Bench bench;
  std::vector<isa::Segment> segments{{.region = {0, 0, 4, 2}, .instructions = {}},
                                     {.region = square, .instructions = {}}};
  systemc::SegmentNames names;
  sc_core::sc_fifo<isa::LinkWord> link{"link", 100};
  sc_core::sc_fifo<PortWord> colours;
  sc_core::sc_signal<std::uint64_t> finished{"finished"};
  systemc::Retirement retirement{"retirement"};
  Listener listener;
  Renderer renderer;
};

/// Returns the square's colours after the instructions, as computed by the reference.
std::vector<std::uint32_t> reference_colours(const std::vector<Instruction>& instructions) {
  reference::ReferenceArray judge(isa::Region{0, 0, square.width, square.height}, 8);
  for (const Instruction& one : instructions) judge.execute(one);
  std::vector<std::uint32_t> values(std::size_t{square.width} * square.height);
  judge.read_field(colour, values);
  return values;
}

/// Checks that the square is finished at this edge and not earlier.
void check_finished_at(Board& board, std::uint64_t edge) {
  board.bench.edges(edge - 1);
  CHECK(board.finished.read() == 0);
  board.bench.edges(1);
  CHECK(board.finished.read() == 1);
}

}  // namespace

TEST_CASE("a renderer draws on while finished squares wait until the backing store is full") {
  // Two squares of 4 bits per pixel fit. The port has room for one word of the first.
  Board board({.backing_bits = 8, .port_bits = port_bits}, 1);
  for (int i = 0; i < 3; ++i) board.send({enable_all, ramp});
  board.bench.edges(100);
  CHECK(board.finished.read() == 2);
  std::vector<PortWord> words;
  while (words.size() < square_words) {
    words.push_back(board.colours.read());
    board.bench.edges(1);
  }
  board.bench.edges(2);
  CHECK(board.finished.read() == 3);
  CHECK(testing::bits_of(words, port_bits) ==
        testing::travelling(square, reference_colours({enable_all, ramp}), colour.width, port_bits));
}

TEST_CASE("a square moves to the backing store a few bits of all pixels per clock") {
  // Eight pixels of 4 bits.
  Board board({.backing_bits = 4, .backing_width = 5, .port_bits = port_bits}, 100);
  board.send({enable_all, ramp});
  board.bench.edges(drawn_at + 6);
  CHECK(board.finished.read() == 0);
  CHECK(board.colours.num_available() == 0);
  board.bench.edges(1);
  CHECK(board.finished.read() == 1);
  board.bench.edges(1);
  CHECK(board.colours.num_available() == 1);
}

TEST_CASE("a query without enabled pixels drops the skipped instructions a word per clock") {
  // The query is issued at 7, and its answer arrives when its step has passed three levels of the tree, at 11. Then
  // the waiting instruction is dropped, the next at 12, and SegmentEnd is taken at 13.
  const Instruction query{.opcode = Opcode::skip_if_none, .constant = 2};
  Board board(2, 0, 100);
  board.send({query, ramp, enable_all});
  check_finished_at(board, 16);
  REQUIRE(board.listener.instructions.size() == 1);
  CHECK(board.listener.instructions[0].clocks == 4);
  CHECK(board.listener.instructions[0].skipped == 2);
  CHECK(board.renderer.skipped() == 2);
  CHECK(board.renderer.account(20).of(SquareActivity::working) == clear_clocks + 4 + 4);
}

TEST_CASE("a query with an enabled pixel lets all instructions execute") {
  const Instruction query{.opcode = Opcode::skip_if_none, .constant = 1};
  Board board(2, 0, 100);
  board.send({enable_all, query, ramp});
  check_finished_at(board, drawn_at + 4);
  REQUIRE(board.listener.instructions.size() == 3);
  CHECK(board.listener.instructions[1].skipped == 0);
  CHECK(board.renderer.skipped() == 0);
}

TEST_CASE("each level of a renderer's OR delays a query by one clock") {
  // Eight pixels are combined by gates of three inputs, and those three gates by one.
  const Instruction query{.opcode = Opcode::skip_if_none, .constant = 1};
  Board board({.buffers = 2, .port_bits = port_bits, .has_global_or = true, .or_fan_in = 3}, 100);
  board.send({query, ramp});
  check_finished_at(board, 15 + 2);
  CHECK(board.listener.instructions.at(0).clocks == 4 + 2);
}

TEST_CASE("a square moves to the second buffer at once and leaves from the next edge on") {
  Board board(2, pixel_square::all_planes, 100);
  board.send({enable_all, ramp});
  check_finished_at(board, drawn_at);
  CHECK(board.colours.num_available() == 0);
  board.bench.edges(1);
  CHECK(board.colours.num_available() == 1);
  board.bench.edges(square_words - 1);
  CHECK(testing::bits_of(testing::drained(board.colours), port_bits) ==
        testing::travelling(square, reference_colours({enable_all, ramp}), colour.width, port_bits));

  const pixel_square::SquareClocks account = board.renderer.account(28);
  CHECK(account.of(SquareActivity::waiting_for_divider) == 1);
  CHECK(account.of(SquareActivity::working) == drawn_at - 1);
  CHECK(account.of(SquareActivity::done) == 28 - drawn_at);

  CHECK(board.listener.squares == std::vector<std::uint32_t>{1});
  REQUIRE(board.listener.instructions.size() == 2);
  CHECK(board.listener.instructions[0].clocks == 1);
  CHECK(board.listener.instructions[0].enabled_pixels == 0);
  CHECK(board.listener.instructions[1].clocks == 6);
  CHECK(board.listener.instructions[1].enabled_pixels == 6);
}

TEST_CASE("four bits of colour move in two clocks at three bit planes per clock") {
  Board board(2, 3, 100);
  board.send({enable_all, ramp});
  check_finished_at(board, drawn_at + 2);
  CHECK(board.colours.num_available() == 0);
  board.bench.edges(1);
  CHECK(board.colours.num_available() == 1);
  CHECK(board.renderer.account(20).of(SquareActivity::working) == drawn_at - 1 + 2);
}

TEST_CASE("without a second buffer a square is finished when its last word has left") {
  Board board(1, pixel_square::all_planes, 100);
  board.send({enable_all, ramp});
  check_finished_at(board, drawn_at + square_words);
  CHECK(board.colours.num_available() == static_cast<int>(square_words));
  CHECK(board.renderer.account(28).of(SquareActivity::waiting_for_frame_buffer) == square_words);
}

TEST_CASE("without a second buffer the latch refills while a row leaves") {
  // A row of three colours has 12 bits. Its four bit planes are latched at 18 to 21, and it transfers at 22; the second
  // row is latched at 22 to 25. The eight words of the header leave meanwhile, at 18 to 25. The first word of colours
  // leaves at 26; the second needs the second row, which transfers at 27.
  Board board({.buffers = 1, .latch_bits = 1, .port_bits = port_bits}, 100);
  board.send({enable_all, ramp});
  board.bench.edges(drawn_at + 8);
  CHECK(board.colours.num_available() == 8);
  board.bench.edges(1);
  CHECK(board.colours.num_available() == 9);
  CHECK(board.finished.read() == 0);
  board.bench.edges(2);
  CHECK(board.finished.read() == 1);
  CHECK(testing::bits_of(testing::drained(board.colours), port_bits) ==
        testing::travelling(square, reference_colours({enable_all, ramp}), colour.width, port_bits));
}

TEST_CASE("a slow row latch delays the row's words and not the header") {
  // A port of 64 bits: the header is one word, at 18, and all colours are one more: it needs both rows, the first
  // latched at 18 to 21 and transferred at 22, the second at 22 to 25 and transferred at 26.
  Board board({.buffers = 1, .latch_bits = 1, .port_bits = 64}, 100);
  board.send({enable_all, ramp});
  board.bench.edges(drawn_at + 8);
  CHECK(board.colours.num_available() == 1);
  board.bench.edges(1);
  CHECK(board.colours.num_available() == 2);
  CHECK(board.finished.read() == 1);
  CHECK(board.renderer.account(30).of(SquareActivity::waiting_for_frame_buffer) == 9);
}

TEST_CASE("a square is drawn while the previous one is sent and waits for its last word") {
  Board board(2, pixel_square::all_planes, 1);
  const Instruction two{.opcode = Opcode::set_constant, .fields = {colour}, .constant = 2};
  board.send({enable_all, ramp});
  board.send({enable_all, two});
  board.bench.edges(drawn_at + 100);
  CHECK(board.finished.read() == 1);
  CHECK(board.renderer.pixels().memory_bit(colour.base + 1U, 2, 1));  // belongs to the second square
  std::vector<PortWord> words;
  while (words.size() + 1 < square_words) {
    CHECK(board.finished.read() == 1);
    words.push_back(board.colours.read());
    board.bench.edges(1);
  }
  board.bench.edges(1);  // the last word has been in the FIFO since the previous edge
  CHECK(board.finished.read() == 2);
  words.push_back(board.colours.read());
  CHECK(testing::bits_of(words, port_bits) ==
        testing::travelling(square, reference_colours({enable_all, ramp}), colour.width, port_bits));
  words.clear();
  while (words.size() < square_words) {
    board.bench.edges(1);
    words.push_back(board.colours.read());
  }
  CHECK(testing::bits_of(words, port_bits) ==
        testing::travelling(square, reference_colours({enable_all, two}), colour.width, port_bits));
  CHECK(board.listener.squares == std::vector<std::uint32_t>{1, 1});
}

namespace {

/// A port of 64 bits: the square has two words; they leave at the edges after the one at which it is finished,
/// without waiting for a row.
void check_unlatched(pixel_square::Figures figures) {
  figures.port_bits = 64;
  figures.latch_bits = 1;
  Board board(figures, 100);
  board.send({enable_all, ramp});
  check_finished_at(board, drawn_at);
  board.bench.edges(2);
  CHECK(board.colours.num_available() == 2);
}

}  // namespace

TEST_CASE("no row is latched if a square leaves from a second buffer") { check_unlatched({.buffers = 2}); }

TEST_CASE("no row is latched if a square leaves from the backing store") {
  check_unlatched({.buffers = 1, .backing_bits = 8});
}
