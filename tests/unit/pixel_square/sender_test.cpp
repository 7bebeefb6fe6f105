// SystemC elaborates once per process, so ctest runs each case here in a separate process.

#include "hw/isa/opcodes.h"
#include "hw/isa/wire.h"
#include "hw/pixel_square/host_sender.h"
#include "tests/support/test.h"
#include "tests/unit/pixel_square/bench.h"

using namespace csgsim;
using namespace pixel_square;
using testing::Bench;

namespace {

/// Word width at which every command takes one word.
constexpr std::uint32_t wide = 256;
constexpr std::uint32_t port_bits = 16;
constexpr std::uint64_t header_words = 4;
constexpr std::uint64_t square_words = 3;

struct Board {
  Board(const machines::Link& link, std::uint32_t renderers)
      : machine(testing::square_machine({.renderers = renderers, .port_bits = port_bits}, link)),
        bench(machine),
        links("links", renderers,
              [&](const char* name, std::size_t) {
                return new sc_core::sc_fifo<isa::LinkWord>(name, static_cast<int>(link.fifo_depth));
              }),
        finished("finished", renderers),
        sender("sender", machine) {
    sender.clock(bench.clock);
    sender.links(links);
    sender.finished(finished);
    sender.clears(clears);
    sender.retirement(retirement);
    retirement.begin(listener);
  }

  machines::Machine machine;
  Bench bench;
  sc_core::sc_vector<sc_core::sc_fifo<isa::LinkWord>> links;
  sc_core::sc_vector<sc_core::sc_signal<std::uint64_t>> finished;
  sc_core::sc_fifo<PortWord> clears{"clears", 100};
  systemc::Retirement retirement{"retirement"};
  testing::SquareListener listener;
  HostSender sender;
};

isa::Segment square(std::uint32_t x, bool drawn) {
  isa::Segment segment{.region = {x, 0, 2, 2}, .instructions = {}};
  if (drawn) segment.instructions.push_back({.opcode = isa::Opcode::enable_all});
  return segment;
}

}  // namespace

TEST_CASE("the sender sends a word in the last of its clocks and an empty square as header") {
  const std::vector<isa::Segment> squares{square(0, true), square(2, false)};
  Board board({.width = wide, .word_clocks = 3, .fifo_depth = 9, .latency = 4}, 1);
  board.sender.begin(squares);
  board.bench.edges(4);
  for (int sent = 0; sent < static_cast<int>(square_words); ++sent) {
    board.bench.edges(2);
    CHECK(board.links[0].num_available() == sent);
    board.bench.edges(1);
    CHECK(board.links[0].num_available() == sent + 1);
  }
  for (int sent = 0; sent < static_cast<int>(header_words); ++sent) {
    board.bench.edges(2);
    CHECK(board.clears.num_available() == sent);
    CHECK(board.listener.squares.empty());
    board.bench.edges(1);
    CHECK(board.clears.num_available() == sent + 1);
  }
  CHECK(board.listener.squares == std::vector<std::uint32_t>{1});
  CHECK(board.sender.squares_skipped() == 1);

  isa::WireDecoder decoder(wide);
  std::vector<isa::Command> commands;
  for (const isa::LinkWord& word : testing::drained(board.links[0])) commands.push_back(decoder.take(word).value());
  REQUIRE(commands.size() == square_words);
  CHECK(std::get<isa::SegmentStart>(commands[0]).region == squares[0].region);
  CHECK(std::get<isa::Instruction>(commands[1]).opcode == isa::Opcode::enable_all);
  CHECK(std::holds_alternative<isa::SegmentEnd>(commands[2]));
  CHECK(testing::bits_of(testing::drained(board.clears), port_bits) ==
        testing::travelling(squares[1].region, {}, 0, port_bits));

  const pixel_square::SquareClocks account = board.sender.account(30);
  CHECK(account.of(SquareActivity::waiting_for_host) == 4);
  CHECK(account.of(SquareActivity::working) == 3 * (square_words + header_words));
  CHECK(account.of(SquareActivity::done) == 30 - 4 - 21);
}

TEST_CASE("the sender sends a square to the first renderer with the fewest unfinished ones") {
  std::vector<isa::Segment> squares;
  for (std::uint32_t i = 0; i < 6; ++i) squares.push_back(square(2 * i, true));
  Board board({.width = wide, .word_clocks = 1, .fifo_depth = 99, .latency = 0}, 3);
  board.sender.begin(squares);
  const auto words = [&](std::size_t renderer) { return board.links[renderer].num_available(); };
  board.bench.edges(3 * square_words);  // one square each
  CHECK((words(0) == 3 && words(1) == 3 && words(2) == 3));
  board.finished[2].write(1);
  board.bench.edges(square_words);
  CHECK(words(2) == 6);
  board.bench.edges(square_words);  // all renderers have one unfinished square again
  CHECK(words(0) == 6);
  board.finished[0].write(2);
  board.bench.edges(square_words);
  CHECK(words(0) == 9);
  CHECK(words(1) == 3);
}

TEST_CASE("the sender uses a place in a FIFO one edge after the place became free") {
  const std::vector<isa::Segment> squares{square(0, true)};
  Board board({.width = wide, .word_clocks = 1, .fifo_depth = 1, .latency = 0}, 1);
  board.sender.begin(squares);
  board.bench.edges(5);
  CHECK(board.links[0].num_available() == 1);
  static_cast<void>(board.links[0].read());
  board.bench.edges(1);
  CHECK(board.links[0].num_available() == 1);
  CHECK(board.sender.account(6).of(SquareActivity::working) == 2);
  CHECK(board.sender.account(6).of(SquareActivity::waiting_for_renderer) == 4);
}
