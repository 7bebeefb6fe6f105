// SystemC elaborates once a process, so each case here runs in a process of its own, as ctest does it.

#include "hw/pixel_square/frame_buffer.h"

#include <doctest/doctest.h>

#include <vector>

#include "tests/unit/pixel_square/bench.h"

using namespace csgsim;
using pixel_square::FrameBuffer;
using pixel_square::PortWord;
using pixel_square::SquareActivity;
using testing::Bench;

namespace {

constexpr std::uint32_t port_bits = 8;
constexpr unsigned colour_bits = 3;
constexpr std::uint64_t header_words = 8;

/// A frame buffer of that many renderers, whose FIFOs hold whatever a test writes.
struct Board {
  explicit Board(std::uint32_t renderers)
      : bench(testing::square_machine({})),
        colours("colours", renderers,
                [](const char* name, std::size_t) { return new sc_core::sc_fifo<PortWord>(name, 100); }),
        buffer("buffer", renderers, port_bits) {
    buffer.clock(bench.clock);
    buffer.colours(colours);
    buffer.clears(clears);
    buffer.frames(frames);
  }

  void begin(std::uint64_t squares, std::uint32_t background = 0) {
    buffer.begin({{4, 2}, squares, colour_bits, background});
  }

  void send(std::size_t renderer, const isa::Region& region, const std::vector<std::uint32_t>& square) {
    for (const PortWord& word :
         testing::in_words(testing::travelling(region, square, colour_bits, port_bits), port_bits))
      CHECK(colours[renderer].nb_write(word));
  }

  void clear(const isa::Region& region) {
    for (const PortWord& word : testing::in_words(testing::travelling(region, {}, colour_bits, port_bits), port_bits))
      CHECK(clears.nb_write(word));
  }

  [[nodiscard]] std::vector<std::uint32_t> picture() const {
    return {buffer.picture().begin(), buffer.picture().end()};
  }

  Bench bench;
  sc_core::sc_vector<sc_core::sc_fifo<PortWord>> colours;
  sc_core::sc_fifo<PortWord> clears{"clears", 100};
  sc_core::sc_signal<std::uint64_t> frames{"frames"};
  FrameBuffer buffer;
};

}  // namespace

TEST_CASE("a square stands in its place in the picture when as many clocks have gone by as it has words") {
  // Eight words of header, and two for the 12 bits of four colours; a word is there from the edge after it is written.
  Board board(1);
  board.begin(1);
  board.send(0, {2, 0, 2, 2}, {1, 2, 3, 4});
  board.bench.edges(header_words + 1);
  CHECK(board.frames.read() == 0);
  board.bench.edges(1);
  CHECK(board.frames.read() == 1);
  CHECK(board.picture() == std::vector<std::uint32_t>{0, 0, 1, 2, 0, 0, 3, 4});
  board.bench.edges(5);
  const pixel_square::SquareClocks account = board.buffer.account(15);
  CHECK(account.of(SquareActivity::working) == 10);
  CHECK(account.of(SquareActivity::waiting_for_renderer) == 5);
}

TEST_CASE("renderers take turns, word by word, and a renderer without a word is passed over") {
  // Ten words of each: the turns of the first three ports go round, so that 20 clocks take ten words of two of them.
  Board board(3);
  board.begin(2);
  board.send(0, {0, 0, 2, 2}, {1, 2, 3, 4});
  board.send(2, {2, 0, 2, 2}, {5, 6, 7, 0});
  for (int left = 9; left >= 0; --left) {
    board.bench.edges(1);
    CHECK(board.colours[0].num_available() == left);
    CHECK(board.colours[2].num_available() == left + 1);
    board.bench.edges(1);
    CHECK(board.colours[2].num_available() == left);
  }
  CHECK(board.frames.read() == 1);
  CHECK(board.picture() == std::vector<std::uint32_t>{1, 2, 5, 6, 3, 4, 7, 0});
}

TEST_CASE("a square that is cleared gets its background in as many clocks as its colours would be words, in turns") {
  // The square's ten words go by turns with the other's eight words of header and two of background. The renderer's
  // port comes first: its ninth word is the 17th, with two colours and two zeros of the third. The 18th is the first
  // word of background, with as much.
  Board board(1);
  board.begin(2, 4);
  board.send(0, {2, 0, 2, 2}, {1, 2, 4, 3});
  board.clear({0, 0, 2, 2});
  board.bench.edges(17);
  CHECK(board.picture() == std::vector<std::uint32_t>{0, 0, 1, 2, 0, 0, 0, 0});
  board.bench.edges(1);
  CHECK(board.picture() == std::vector<std::uint32_t>{4, 4, 1, 2, 0, 0, 0, 0});
  CHECK(board.frames.read() == 0);
  board.bench.edges(2);
  CHECK(board.frames.read() == 1);
  CHECK(board.picture() == std::vector<std::uint32_t>{4, 4, 1, 2, 4, 4, 4, 3});
}

TEST_CASE(
    "a frame begins at the first port, keeps the picture before, and no word wakes the frame buffer too soon or too "
    "late") {
  Board board(2);
  board.begin(1, 5);
  board.bench.edges(7);
  board.clear({0, 0, 4, 1});
  board.bench.edges(header_words + 1);
  CHECK(board.frames.read() == 0);
  board.bench.edges(1);
  CHECK(board.frames.read() == 1);
  board.begin(1);
  board.bench.edges(3);
  board.send(1, {0, 1, 1, 1}, {7});
  board.bench.edges(header_words);
  CHECK(board.frames.read() == 1);
  board.bench.edges(1);
  CHECK(board.frames.read() == 2);
  CHECK(board.picture() == std::vector<std::uint32_t>{5, 5, 5, 5, 7, 0, 0, 0});
  CHECK(board.buffer.account(12).of(SquareActivity::working) == header_words + 1);
}

TEST_CASE("ports take turns from the first again in every frame, whichever was served last") {
  Board board(2);
  board.begin(1);
  board.send(0, {0, 0, 1, 1}, {7});
  board.bench.edges(header_words + 2);
  REQUIRE(board.frames.read() == 1);
  board.begin(2);
  board.send(0, {0, 0, 1, 1}, {1});
  board.send(1, {1, 0, 1, 1}, {2});
  constexpr int words = header_words + 1;
  board.bench.edges(1);
  CHECK(board.colours[0].num_available() == words - 1);
  CHECK(board.colours[1].num_available() == words);
}
