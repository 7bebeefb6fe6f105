// SystemC elaborates once per process, so ctest runs each case here in a separate process.

#include "hw/pixel_square/model_source.h"

#include "tests/support/test.h"
#include "tests/unit/pixel_square/bench.h"

using namespace csgsim;
using namespace pixel_square;
using testing::Bench;

namespace {

struct Board {
  Board(const machines::Link& link, int depth)
      : bench(testing::square_machine({})), fifo("fifo", depth), source("source", link) {
    source.clock(bench.clock);
    source.words(fifo);
  }

  Bench bench;
  sc_core::sc_fifo<isa::LinkWord> fifo;
  ModelSource source;
};

}  // namespace

TEST_CASE("a display model's bytes leave the host lowest bit first after the latency") {
  // Three bytes fit two words of 12 bits, which leave at 5 + 2 and 5 + 4; no more follow.
  constexpr std::array<std::uint8_t, 3> model{0x21, 0x43, 0x65};
  Board board({.width = 12, .word_clocks = 2, .fifo_depth = 9, .latency = 5}, 9);
  board.source.begin(model);
  board.bench.edges(6);
  CHECK(board.fifo.num_available() == 0);
  board.bench.edges(1);
  CHECK(board.fifo.num_available() == 1);
  board.bench.edges(1);
  CHECK(board.fifo.num_available() == 1);
  board.bench.edges(12);
  std::vector<std::uint64_t> numbers;
  for (const isa::LinkWord& word : testing::drained(board.fifo)) numbers.push_back(word.number(0, 64));
  CHECK(numbers == std::vector<std::uint64_t>{0x321, 0x654});
  const pixel_square::SquareClocks account = board.source.account(20);
  CHECK(account.of(SquareActivity::waiting_for_host) == 5);
  CHECK(account.of(SquareActivity::working) == 4);
  CHECK(account.of(SquareActivity::done) == 11);
}

TEST_CASE("a model word waits for room in the FIFO and each frame starts after the latency") {
  constexpr std::array<std::uint8_t, 3> model{1, 2, 3};
  Board board({.width = 8, .word_clocks = 1, .fifo_depth = 1, .latency = 1}, 1);
  board.source.begin(model);
  board.bench.edges(4);
  CHECK(board.fifo.read().number(0, 8) == 1);
  board.bench.edges(1);  // sees the place that the reader freed after the previous edge
  CHECK(board.fifo.read().number(0, 8) == 2);
  board.bench.edges(1);
  CHECK(board.fifo.read().number(0, 8) == 3);
  CHECK(board.source.account(6).of(SquareActivity::waiting_for_divider) == 2);
  board.source.begin(model);
  board.bench.edges(1);
  CHECK(board.fifo.num_available() == 0);
  board.bench.edges(1);
  CHECK(board.fifo.num_available() == 1);
}
