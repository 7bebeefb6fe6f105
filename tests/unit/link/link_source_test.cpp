// SystemC elaborates once a process, so each case here runs in a process of its own, as ctest does it.

#include "hw/link/link_source.h"

#include "tests/support/test.h"

using namespace csgsim;
using link::LinkSource;

namespace {

constexpr machines::Link slow{.width = 32, .word_clocks = 3, .fifo_depth = 8, .latency = 2};

/// Of two instructions, a word each.
link::FrameWords two_words() { return {.words = std::vector<isa::LinkWord>(2), .begins = {0, 1, 2}}; }

struct Board {
  Board() : source("source", clock.period(), slow) {
    source.clock(clock);
    source.requests(requests);
    source.words(words);
  }

  /// So many edges go by, and all that belongs to them happens.
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

TEST_CASE("a word that is on the link at the start is there for the clocks that it has left") {
  Board board;
  board.source.resume(two_words(), 1, 2);
  board.edges(1);
  CHECK(board.words.num_available() == 0);
  board.edges(1);
  CHECK(board.words.num_available() == 1);
}

TEST_CASE("the account is of the clocks since the frame's beginning was asked for, with those before a jump") {
  Board board;
  board.source.load(two_words());
  board.edges(5);
  board.requests.write(0);
  board.edges(1 + 2 + 3);
  CHECK(board.source.account() == machines::LinkAccount{.words = 1, .sending = 3, .waiting = 1 + 2});
  board.requests.write(1);
  board.edges(1 + 2 + 3);  // in the first of them the second word is on the link, in vain
  board.edges(1);
  CHECK(board.source.account() == machines::LinkAccount{.words = 2, .sending = 3 + 1 + 3, .waiting = 3 + 2, .done = 1});
}
