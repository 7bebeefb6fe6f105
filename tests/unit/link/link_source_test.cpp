// SystemC elaborates once per process, so each case must run in a separate process, as under ctest.

#include "hw/link/link_source.h"

#include "tests/support/test.h"

using namespace csgsim;
using link::LinkSource;

namespace {

constexpr machines::Link slow{.width = 32, .word_clocks = 3, .fifo_depth = 8, .latency = 2};

/// Words of two instructions, one each.
link::FrameWords two_words() { return {.words = std::vector<isa::LinkWord>(2), .begins = {0, 1, 2}}; }

struct Board {
  Board() : source("source", clock.period(), slow) {
    source.clock(clock);
    source.requests(requests);
    source.words(words);
  }

  /// Runs `count` clock edges and everything that they trigger.
  void edges(std::uint64_t count) {
    if (sc_core::sc_get_status() == sc_core::SC_ELABORATION) sc_core::sc_start(clock.period() / 2);
    for (std::uint64_t i = 0; i < count; ++i) sc_core::sc_start(clock.period());
  }

  sc_core::sc_clock clock{"clock", {100, sc_core::SC_NS}, 0.5, {100, sc_core::SC_NS}};
  sc_core::sc_fifo<std::uint64_t> requests{"requests", 1};
  sc_core::sc_fifo<isa::LinkWord> words{"words", slow.fifo_depth};
  LinkSource source;
};

}  // namespace

TEST_CASE("a resumed word stays on the link for its remaining clocks") {
  Board board;
  board.source.resume(two_words(), 1, 2);
  board.edges(1);
  CHECK(board.words.num_available() == 0);
  board.edges(1);
  CHECK(board.words.num_available() == 1);
}

TEST_CASE("the account covers the clocks since the request including an abandoned word") {
  Board board;
  board.source.load(two_words());
  board.edges(5);
  board.requests.write(0);
  board.edges(1 + 2 + 3);
  CHECK(board.source.account() == machines::LinkAccount{.words = 1, .sending = 3, .waiting = 1 + 2});
  board.requests.write(1);
  board.edges(1 + 2 + 3);  // the second word is on the link in the first of these clocks and is discarded
  board.edges(1);
  CHECK(board.source.account() == machines::LinkAccount{.words = 2, .sending = 3 + 1 + 3, .waiting = 3 + 2, .done = 1});
}
