// SystemC elaborates once per process, so ctest runs each case here in a separate process.

#include "hw/pixel_square/ring.h"

#include "tests/support/test.h"
#include "tests/unit/pixel_square/bench.h"

using namespace csgsim;
using namespace pixel_square;
using testing::Bench;

namespace {

template <class Word>
auto deep(int depth) {
  return [depth](const char* name, std::size_t /*index*/) { return new sc_core::sc_fifo<Word>(name, depth); };
}

/// A ring whose sources hold any number of words and whose targets have room for `room` words.
struct Board {
  explicit Board(pixel_square::Figures figures, int room = 100)
      : machine(testing::square_machine(with_ring(figures))),
        bench(machine),
        processors("processors", figures.processors, deep<RingWord>(100)),
        targets("targets", figures.processors),
        renderers("renderers", figures.renderers, deep<PortWord>(100)),
        links("links", figures.renderers, deep<isa::LinkWord>(room)),
        colours("colours", figures.renderers, deep<PortWord>(room)),
        clears("clears", figures.processors, deep<PortWord>(room)),
        ring("ring", machine) {
    ring.clock(bench.clock);
    ring.processors(processors);
    ring.targets(targets);
    ring.renderers(renderers);
    ring.links(links);
    ring.colours(colours);
    ring.clears(clears);
  }

  static pixel_square::Figures with_ring(pixel_square::Figures figures) {
    figures.divider = pixel_square::DividerKind::processors;
    return figures;
  }

  void offer(std::size_t processor, std::uint64_t target, int count) {
    targets[processor].write(target);
    for (int i = 0; i < count; ++i) CHECK(processors[processor].nb_write({}));
  }
  void offer_colours(std::size_t renderer, int count) {
    for (int i = 0; i < count; ++i) CHECK(renderers[renderer].nb_write({{static_cast<std::uint64_t>(i)}}));
  }

  machines::Machine machine;
  Bench bench;
  sc_core::sc_vector<sc_core::sc_fifo<RingWord>> processors;
  sc_core::sc_vector<sc_core::sc_signal<std::uint64_t>> targets;
  sc_core::sc_vector<sc_core::sc_fifo<PortWord>> renderers;
  sc_core::sc_vector<sc_core::sc_fifo<isa::LinkWord>> links;
  sc_core::sc_vector<sc_core::sc_fifo<PortWord>> colours;
  sc_core::sc_vector<sc_core::sc_fifo<PortWord>> clears;
  Ring ring;
};

}  // namespace

TEST_CASE("the ring delivers a word per source in the last of the word's clocks") {
  Board board({.renderers = 2, .banks = 2, .processors = 2, .ring_word_clocks = 3});
  board.ring.begin();
  board.offer(0, 1, 2);
  board.offer(1, 2, 2);
  board.offer_colours(1, 2);
  for (int carried = 0; carried < 2; ++carried) {
    board.bench.edges(2);
    CHECK(board.links[1].num_available() == carried);
    board.bench.edges(1);
    CHECK(board.links[1].num_available() == carried + 1);
    CHECK(board.clears[1].num_available() == carried + 1);
    CHECK(board.colours[1].num_available() == carried + 1);
  }
  CHECK(board.links[0].num_available() == 0);
  CHECK(board.clears[0].num_available() == 0);
  CHECK(board.colours[0].num_available() == 0);
  board.bench.edges(4);
  const pixel_square::RingAccount account = board.ring.account(10);
  CHECK(account.words == 6);
  CHECK(account.clocks.of(SquareActivity::working) == 6);
  CHECK(account.clocks.of(SquareActivity::waiting_for_divider) == 4);
  CHECK(account.full_clocks == 6);  // the frame buffer received a word through each bank
}

TEST_CASE("a renderer takes one word per clock and the frame buffer one per bank") {
  Board board({.renderers = 3, .banks = 2, .processors = 2});
  board.ring.begin();
  board.offer(0, 0, 3);
  board.offer(1, 0, 3);
  for (std::size_t i = 0; i < 3; ++i) board.offer_colours(i, 3);
  const auto left = [&](std::size_t source) {
    return source < 2 ? board.processors[source].num_available() : board.renderers[source - 2].num_available();
  };
  const auto check = [&](const std::vector<int>& expected) {
    board.bench.edges(1);
    for (std::size_t i = 0; i < expected.size(); ++i) CHECK(left(i) == expected[i]);
  };
  check({2, 3, 2, 2, 3});  // the renderer of processor 1 and the banks of renderer 2 are taken
  check({1, 3, 1, 2, 2});  // order from renderer 2 on: renderer 2, processor 0, renderer 0
  check({0, 3, 1, 1, 1});  // order from renderer 1 on: renderer 1, renderer 2, processor 0
  check({0, 2, 0, 0, 1});  // order from processor 1 on: processor 1, renderers 0 and 1
}

TEST_CASE("a ring of two channels serves two sources per clock in round-robin order") {
  Board board({.renderers = 3, .banks = 9, .processors = 1, .ring_channels = 2});
  board.ring.begin();
  for (std::size_t i = 0; i < 3; ++i) board.offer_colours(i, 2);
  const auto carried = [&] {
    board.bench.edges(1);
    return std::vector<int>{board.colours[0].num_available(), board.colours[1].num_available(),
                            board.colours[2].num_available()};
  };
  CHECK(carried() == std::vector<int>{1, 1, 0});
  CHECK(carried() == std::vector<int>{2, 1, 1});
  CHECK(carried() == std::vector<int>{2, 2, 2});
  CHECK(board.ring.account(9).full_clocks == 3);
}

TEST_CASE("the ring skips a source whose target has no room") {
  Board board({.renderers = 2, .banks = 2, .processors = 2, .ring_channels = 1}, 1);
  board.ring.begin();
  board.offer(0, 0, 2);
  board.offer(1, 1, 1);
  board.bench.edges(3);
  CHECK(board.processors[0].num_available() == 1);
  CHECK(board.processors[1].num_available() == 0);
  static_cast<void>(board.links[0].read());
  board.bench.edges(1);
  CHECK(board.processors[0].num_available() == 0);
}
