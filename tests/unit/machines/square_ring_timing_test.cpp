#include "tests/support/test.h"
#include "tests/unit/machines/square_timing.h"

using namespace csgsim;
using namespace csgsim::testing::squares;

TEST_CASE("on a ring a header travels in the last of its clocks and is stored a clock later") {
  // Eight words of header are sent at 1 to 8, carried at 3, 6, ... 24, and taken at 4, 7, ... 25; 12 bits are cleared
  // at 26 and 27.
  const isa::Program program = make_program(3, {square(2, {})});
  const Figures figures = on_a_ring({.port_fifo_depth = 8, .ring_bits = 8, .ring_word_clocks = 3});
  const Timing timing = time(program, make_machine(2, figures));
  CHECK(timing.clocks == 27);
  CHECK(timing.account.squares_skipped == 1);
  CHECK(timing.account.processors == std::vector<Clocks>{{8, 0, 0, 0, 0, 3, 0, 16}});
  REQUIRE(timing.account.ring);
  CHECK(timing.account.ring->clocks == Clocks{24, 0, 3});
  CHECK(timing.account.ring->words == 8);
  CHECK(timing.account.ring->full_clocks == 24);
  CHECK(timing.account.frame_buffer == Clocks{10, 0, 0, 17});
}

TEST_CASE("on a ring a square's commands and colours each take a clock more than on links") {
  // Words leave the processor at 1 to 4 and are carried at 2 to 5; the decoder takes them at 3 to 6, and everything
  // else is a clock later than over a link. Words of the square leave at 12, 13, 14, are carried a clock later, and are
  // stored another clock later.
  const isa::Program program = make_program(3, {square(2, {enable, set({0, 3})})});
  Machine machine = make_machine(2, on_a_ring({.buffers = 2, .port_fifo_depth = 8, .ring_bits = 32}));
  machine.link.width = 1;
  const Timing wide_words = time(program, machine);
  machines::kind_figures<Figures>(machine).ring_bits = 256;
  machines::kind_figures<Figures>(machine).port_bits = 1;
  const Timing timing = time(program, machine);
  // A header and two words of colours: they leave at 12 and 13.
  CHECK(timing.clocks == 15);
  CHECK(timing.account.renderers == std::vector<Clocks>{{8, 0, 3, 0, 0, 4}});
  CHECK(timing.account.processors == std::vector<Clocks>{{4, 0, 0, 0, 0, 10, 0, 1}});
  // The region in words of 32 bits takes three, so the header takes one more and the start two more.
  CHECK(wide_words.clocks == timing.clocks + 2 + 1);
}

TEST_CASE("two processors feed two renderers at once and one renderer in turn") {
  // A square takes three words. Over the ring both squares arrive at once; with one renderer the second starts when the
  // last word of the first has been carried, at 4, so its words are carried at 6, 7, 8.
  const isa::Program program = make_program(1, {square(1, {enable}), square(1, {enable})});
  const auto account = [&](std::uint32_t renderers) {
    return time(program, make_machine(1, on_a_ring({.renderers = renderers,
                                                    .buffers = 2,
                                                    .port_fifo_depth = 8,
                                                    .banks = 2,
                                                    .processors = 2,
                                                    .ring_bits = 256})))
        .account;
  };
  const pixel_square::SquareAccount two = account(2);
  CHECK(two.renderer_squares == std::vector<std::uint64_t>{1, 1});
  CHECK(two.processors[0].clocks == two.processors[1].clocks);
  CHECK(two.processors[0].of(pixel_square::SquareActivity::waiting_for_renderer) == 0);
  const pixel_square::SquareAccount one = account(1);
  CHECK(one.processors[0] == Clocks{3, 0, 0, 0, 0, one.processors[0].of(pixel_square::SquareActivity::done), 0, 1});
  CHECK(one.processors[1] == Clocks{3, 0, 0, 4, 0, one.processors[1].of(pixel_square::SquareActivity::done), 0, 1});
}

TEST_CASE("words on a ring wait for each other at one target or if channels are short") {
  // Three squares to clear, each with a word of header and one of background. Their headers are carried together at 2,
  // or one per clock.
  const isa::Program program = make_program(1, {square(1, {}), square(1, {}), square(1, {})});
  const auto clocks = [&](std::uint32_t channels, std::uint32_t banks) {
    Figures figures = on_a_ring({.port_fifo_depth = 8, .banks = banks, .processors = 3, .ring_bits = 64});
    figures.ring_channels = channels;
    return time(program, make_machine(1, figures))
        .account.ring.value()
        .clocks.of(pixel_square::SquareActivity::working);
  };
  CHECK(clocks(pixel_square::all_channels, 3) == 1);
  CHECK(clocks(2, 3) == 2);
  CHECK(clocks(1, 3) == 3);
  CHECK(clocks(3, 1) == 3);
}
