// SystemC elaborates once per process, so ctest runs each case here in a separate process.

#include "hw/pixel_square/frame_buffer.h"

#include "hw/pixel_square/taps.h"
#include "hw/systemc/segment_names.h"
#include "tests/support/test.h"
#include "tests/unit/pixel_square/bench.h"

using namespace csgsim;
using namespace pixel_square;
using testing::Bench;

namespace {

constexpr std::uint32_t port_bits = 8;
constexpr unsigned colour_bits = 3;
constexpr std::uint64_t header_words = 8;

/// A frame buffer with FIFOs deep enough for all words of a test.
struct Board {
  explicit Board(std::uint32_t renderers)
      : Board(pixel_square::Figures{.renderers = renderers, .port_bits = port_bits}) {}

  explicit Board(const pixel_square::Figures& figures, std::uint64_t clock_hz = 10'000'000)
      : bench(make_machine(figures, clock_hz)),
        colours("colours", figures.renderers,
                [](const char* name, std::size_t) { return new sc_core::sc_fifo<PortWord>(name, 100); }),
        buffer("buffer", make_machine(figures, clock_hz)) {
    buffer.clock(bench.clock);
    buffer.colours(colours);
    buffer.clears[0](clears);
    buffer.frames(frames);
  }

  static machines::Machine make_machine(const pixel_square::Figures& figures, std::uint64_t clock_hz) {
    machines::Machine machine = testing::square_machine(figures);
    machine.clock_hz = clock_hz;
    return machine;
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

  /// Returns the number of frames completed after `edges` more edges.
  std::uint64_t frames_after(std::uint64_t edges) {
    bench.edges(edges);
    return frames.read();
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

TEST_CASE("a square takes one clock per word to reach the picture") {
  // Eight words of header, and two for the 12 bits of four colours; a word is readable from the edge after its write.
  Board board(1);
  board.begin(1);
  board.send(0, {2, 0, 2, 2}, {1, 2, 3, 4});
  CHECK(board.frames_after(header_words + 1) == 0);
  CHECK(board.frames_after(1) == 1);
  CHECK(board.picture() == std::vector<std::uint32_t>{0, 0, 1, 2, 0, 0, 3, 4});
  board.bench.edges(5);
  const pixel_square::SquareClocks account = board.buffer.account(15);
  CHECK(account.of(SquareActivity::working) == 10);
  CHECK(account.of(SquareActivity::waiting_for_renderer) == 5);
}

TEST_CASE("renderers take turns at the frame buffer word by word and idle ones are skipped") {
  // Ten words each: the first three ports take turns, so that 20 clocks take ten words of each of two ports.
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

TEST_CASE("a cleared square takes the words of a drawn one and alternates with renderers") {
  // The drawn square's ten words alternate with the cleared square's eight words of header and two of background. The
  // renderer's port is first: its ninth word, with two colours and two zeros of the third, is taken at 17, and the
  // first word of background at 18.
  Board board(1);
  board.begin(2, 4);
  board.send(0, {2, 0, 2, 2}, {1, 2, 4, 3});
  board.clear({0, 0, 2, 2});
  board.bench.edges(17);
  CHECK(board.picture() == std::vector<std::uint32_t>{0, 0, 1, 2, 0, 0, 0, 0});
  board.bench.edges(1);
  CHECK(board.picture() == std::vector<std::uint32_t>{4, 4, 1, 2, 0, 0, 0, 0});
  CHECK(board.frames.read() == 0);
  CHECK(board.frames_after(2) == 1);
  CHECK(board.picture() == std::vector<std::uint32_t>{4, 4, 1, 2, 4, 4, 4, 3});
}

TEST_CASE("a frame keeps the previous frame's pixels outside its squares") {
  Board board(2);
  board.begin(1, 5);
  board.bench.edges(7);
  board.clear({0, 0, 4, 1});
  CHECK(board.frames_after(header_words + 1) == 0);
  CHECK(board.frames_after(1) == 1);
  board.begin(1);
  board.bench.edges(3);
  board.send(1, {0, 1, 1, 1}, {7});
  CHECK(board.frames_after(header_words) == 1);
  CHECK(board.frames_after(1) == 2);
  CHECK(board.picture() == std::vector<std::uint32_t>{5, 5, 5, 5, 7, 0, 0, 0});
  CHECK(board.buffer.account(12).of(SquareActivity::working) == header_words + 1);
}

TEST_CASE("each frame serves the first port first whichever was served last") {
  Board board(2);
  board.begin(1);
  board.send(0, {0, 0, 1, 1}, {7});
  REQUIRE(board.frames_after(header_words + 2) == 1);
  board.begin(2);
  board.send(0, {0, 0, 1, 1}, {1});
  board.send(1, {1, 0, 1, 1}, {2});
  constexpr int words = header_words + 1;
  board.bench.edges(1);
  CHECK(board.colours[0].num_available() == words - 1);
  CHECK(board.colours[1].num_available() == words);
}

TEST_CASE("two banks take words of two squares per clock in rows of different banks") {
  // Each square has eight words of header and two of colours, in one row.
  Board board(pixel_square::Figures{.renderers = 2, .port_bits = port_bits, .banks = 2});
  board.begin(2);
  board.send(0, {0, 0, 4, 1}, {1, 2, 3, 4});
  board.send(1, {0, 1, 4, 1}, {5, 6, 7, 0});
  CHECK(board.frames_after(header_words + 1) == 0);
  CHECK(board.frames_after(1) == 1);
  CHECK(board.picture() == std::vector<std::uint32_t>{1, 2, 3, 4, 5, 6, 7, 0});
  CHECK(board.buffer.account(10).of(SquareActivity::working) == header_words + 2);
}

TEST_CASE("two words for one bank are taken in turn a clock apart") {
  Board board(pixel_square::Figures{.renderers = 2, .port_bits = port_bits, .banks = 2});
  board.begin(2);
  board.send(0, {0, 0, 2, 1}, {1, 2});
  board.send(1, {2, 0, 2, 1}, {3, 4});
  board.bench.edges(header_words + 1);
  CHECK(board.picture() == std::vector<std::uint32_t>{1, 2, 0, 0, 0, 0, 0, 0});
  CHECK(board.frames_after(1) == 1);
  CHECK(board.picture() == std::vector<std::uint32_t>{1, 2, 3, 4, 0, 0, 0, 0});
}

TEST_CASE("the screen's turns delay words at the frame buffer and are counted separately") {
  // A picture has 24 bits, two turns of 12: 20 turns a second, one in five of 100 clocks a second, at 5 and 6, 10 and
  // 11. The ten words are stored at 1 to 4, 7 to 9 and 12 to 14.
  const pixel_square::Figures figures{
      .port_bits = port_bits, .refresh_rate = 10, .refresh_bits = 12, .refresh_clocks = 2};
  Board board(figures, 100);
  board.begin(1);
  board.send(0, {2, 0, 2, 2}, {1, 2, 3, 4});
  CHECK(board.frames_after(13) == 0);
  CHECK(board.buffer.account(13).of(SquareActivity::refreshing) == 4);
  CHECK(board.frames_after(1) == 1);
  const pixel_square::SquareClocks account = board.buffer.account(14);
  CHECK(account.of(SquareActivity::working) == 10);
  CHECK(account.of(SquareActivity::refreshing) == 4);
  board.bench.edges(6);
  CHECK(board.buffer.account(20).of(SquareActivity::refreshing) == 7);
  CHECK(board.buffer.account(20).of(SquareActivity::waiting_for_renderer) == 3);
}

TEST_CASE("one bank of the frame buffer takes words while the screen reads the other") {
  // The screen reads row 0 at 5 and 6, row 1 at 10 and 11. The header's eight words are taken at 1 to 8 by the free
  // bank. Two of the three words of colours start in row 0 and are taken at 9 and 10; the one of row 1 at 12.
  const pixel_square::Figures figures{
      .port_bits = port_bits, .banks = 2, .refresh_rate = 10, .refresh_bits = 12, .refresh_clocks = 2};
  Board board(figures, 100);
  board.begin(1);
  board.send(0, {0, 0, 3, 2}, {1, 2, 3, 4, 5, 6});
  board.bench.edges(10);
  CHECK(board.colours[0].num_available() == 1);
  CHECK(board.frames_after(1) == 0);
  CHECK(board.frames_after(1) == 1);
  CHECK(board.picture() == std::vector<std::uint32_t>{1, 2, 3, 0, 4, 5, 6, 0});
}

TEST_CASE("a frame buffer's wave shows screen turns and the row read and a square's words") {
  // Same clocks as in the screen-turn test above: the ten words are stored at 1 to 4, 7 to 9 and 12 to 14; the eighth,
  // at 12, ends the header. The screen reads row 0 at 5 and 6, row 1 at 10 and 11.
  const pixel_square::Figures figures{
      .port_bits = port_bits, .refresh_rate = 10, .refresh_bits = 12, .refresh_clocks = 2};
  Board board(figures, 100);
  isa::Program program;
  program.segments = {{.region = {0, 0, 2, 2}, .instructions = {}}, {.region = {2, 0, 2, 2}, .instructions = {}}};
  systemc::SegmentNames names;
  names.begin(program.segments);
  const std::vector<wave::Tap> taps = pixel_square::frame_buffer_taps(board.buffer, program, names);
  const auto shown = [&](const std::string& name) {
    const auto tap = std::ranges::find(taps, "frame_buffer." + name, &wave::Tap::name);
    REQUIRE(tap != taps.end());
    if (tap->show == wave::Show::text) return tap->text().substr(0, 3);
    const wave::Number number = tap->number();
    return number ? std::to_string(*number) : std::string();
  };
  board.begin(1);
  board.send(0, {2, 0, 2, 2}, {1, 2, 3, 4});
  std::string states;
  std::string rows;
  std::string squares;
  for (int edge = 1; edge <= 15; ++edge) {
    board.bench.edges(1);
    states += (shown("state").empty() ? "-" : shown("state")) + " ";
    rows += (shown("refreshed_row").empty() ? "-" : shown("refreshed_row")) + " ";
    squares += (shown("square").empty() ? "-" : shown("square")) + " ";
    CHECK(shown("port") == (shown("state") == "wor" ? "0" : ""));
    CHECK(shown("squares") == (edge < 14 ? "0" : "1"));
  }
  CHECK(states == "wor wor wor wor ref ref wor wor wor ref ref wor wor wor ref ");
  CHECK(rows == "- - - - 0 0 - - - 1 1 - - - 0 ");
  CHECK(squares == "- - - - - - - - - - - 2,0 2,0 2,0 - ");
}

TEST_CASE("screen turns start with the frame if the previous picture had no colours") {
  // A picture without colours takes no turns. A picture of 24 bits then takes them in one of five clocks, as above.
  const pixel_square::Figures figures{
      .port_bits = port_bits, .refresh_rate = 10, .refresh_bits = 12, .refresh_clocks = 2};
  Board board(figures, 100);
  board.buffer.begin({{4, 2}, 1, 0, 0});
  board.bench.edges(7);
  CHECK(board.buffer.account(7).of(SquareActivity::refreshing) == 0);
  board.begin(1);
  board.bench.edges(20);
  CHECK(board.buffer.account(20).of(SquareActivity::refreshing) == 7);  // at 5, 6, 10, 11, 15, 16 and 20
  CHECK(board.buffer.account(20).of(SquareActivity::waiting_for_renderer) == 13);
}
