// SystemC elaborates once per process, so ctest runs each case here in a separate process.

#include "hw/pixel_square/graphics_processors.h"

#include "hw/isa/opcodes.h"
#include "hw/isa/wire.h"
#include "tests/support/test.h"
#include "tests/unit/pixel_square/bench.h"

using namespace csgsim;
using namespace pixel_square;
using testing::Bench;

namespace {

/// Word width at which every command and every header takes one word.
constexpr std::uint32_t wide = 256;
constexpr int square_words = 3;

struct Board {
  Board(std::uint32_t processors, std::uint32_t renderers, std::uint32_t latency = 0, std::uint32_t ring_bits = wide)
      : machine(make_machine(processors, renderers, latency, ring_bits)),
        bench(machine),
        words("words", processors,
              [](const char* name, std::size_t) { return new sc_core::sc_fifo<RingWord>(name, depth); }),
        targets("targets", processors),
        finished("finished", renderers),
        parts("processors", machine) {
    parts.clock(bench.clock);
    parts.words(words);
    parts.targets(targets);
    parts.finished(finished);
    parts.retirement(retirement);
    retirement.begin(listener);
  }

  static machines::Machine make_machine(std::uint32_t processors, std::uint32_t renderers, std::uint32_t latency,
                                        std::uint32_t ring_bits) {
    return testing::square_machine({.renderers = renderers,
                                    .port_fifo_depth = static_cast<std::uint32_t>(depth),
                                    .divider = pixel_square::DividerKind::processors,
                                    .processors = processors,
                                    .ring_bits = ring_bits},
                                   {.width = 1, .word_clocks = 9, .fifo_depth = 1, .latency = latency});
  }

  static constexpr int depth = 9;
  machines::Machine machine;
  Bench bench;
  sc_core::sc_vector<sc_core::sc_fifo<RingWord>> words;
  sc_core::sc_vector<sc_core::sc_signal<std::uint64_t>> targets;
  sc_core::sc_vector<sc_core::sc_signal<std::uint64_t>> finished;
  systemc::Retirement retirement{"retirement"};
  testing::SquareListener listener;
  GraphicsProcessors parts;
};

std::vector<isa::Segment> squares(const std::vector<bool>& drawn) {
  std::vector<isa::Segment> all;
  for (const bool one : drawn) {
    all.push_back({.region = {2 * static_cast<std::uint32_t>(all.size()), 0, 2, 2}, .instructions = {}});
    if (one) all.back().instructions.push_back({.opcode = isa::Opcode::enable_all});
  }
  return all;
}

/// Returns the region of the square whose commands these words hold.
isa::Region region_in(const std::vector<RingWord>& words) {
  isa::WireDecoder decoder(wide);
  return std::get<isa::SegmentStart>(decoder.take(words.at(0).command).value()).region;
}

}  // namespace

TEST_CASE("processors take squares in turn and send a word per clock after the latency") {
  const std::vector<isa::Segment> frame = squares({true, true, true});
  Board board(2, 2, 4);
  board.parts.begin(frame);
  board.bench.edges(4);
  CHECK(board.words[0].num_available() == 0);
  for (int sent = 1; sent <= square_words; ++sent) {
    board.bench.edges(1);
    CHECK(board.words[0].num_available() == sent);
    CHECK(board.words[1].num_available() == sent);
  }
  CHECK(board.targets[0].read() == 0);
  CHECK(board.targets[1].read() == 1);
  board.bench.edges(5);
  CHECK(board.words[0].num_available() == square_words);  // not sent yet
  CHECK(region_in(testing::drained(board.words[1])) == frame[1].region);
  board.bench.edges(square_words);
  CHECK(region_in(testing::drained(board.words[1])) == frame[2].region);
  board.bench.edges(4);
  const pixel_square::SquareClocks account = board.parts.account(1, 20);
  CHECK(account.of(SquareActivity::waiting_for_host) == 4);
  CHECK(account.of(SquareActivity::working) == 2 * square_words);
  CHECK(account.of(SquareActivity::waiting_for_ring) == 5);
  CHECK(account.of(SquareActivity::done) == 5);
}

TEST_CASE("a processor waits until all words of another's square have left for the renderer") {
  const std::vector<isa::Segment> frame = squares({true, true, true});
  Board board(3, 1);
  board.parts.begin(frame);
  board.bench.edges(7);
  CHECK(board.words[1].num_available() == 0);
  CHECK(region_in(testing::drained(board.words[0])) == frame[0].region);
  board.bench.edges(1);
  CHECK(board.words[1].num_available() == 1);
  CHECK(board.words[2].num_available() == 0);
  static_cast<void>(board.words[1].read());
  board.bench.edges(1);
  CHECK(board.words[2].num_available() == 0);
  static_cast<void>(board.words[1].read());  // the FIFO is empty for a clock, but the square's last word follows
  board.bench.edges(1);
  CHECK(board.words[1].num_available() == 1);
  CHECK(board.words[2].num_available() == 0);
  static_cast<void>(board.words[1].read());
  board.bench.edges(1);
  CHECK(board.words[2].num_available() == 1);
  CHECK(board.parts.account(2, 11).of(SquareActivity::waiting_for_renderer) == 10);
}

TEST_CASE("a square goes to the first free renderer with the fewest unfinished squares") {
  Board board(1, 3);
  const std::vector<isa::Segment> frame = squares({true, true, true, true, true});
  board.parts.begin(frame);
  std::vector<std::uint64_t> targets;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    board.bench.edges(square_words);
    targets.push_back(board.targets[0].read());
    static_cast<void>(testing::drained(board.words[0]));
    if (i == 2) board.finished[1].write(1);
  }
  CHECK(targets == std::vector<std::uint64_t>{0, 1, 2, 1, 0});
}

TEST_CASE("a processor sends an empty square as a header to the frame buffer") {
  const std::vector<isa::Segment> frame = squares({false, true});
  Board board(1, 2, 0, 16);
  board.parts.begin(frame);
  board.bench.edges(3);
  CHECK(board.listener.squares.empty());
  board.bench.edges(1);
  CHECK(board.listener.squares == std::vector<std::uint32_t>{0});
  CHECK(board.parts.squares_skipped() == 1);
  CHECK(board.targets[0].read() == 2);
  std::vector<pixel_square::PortWord> header;
  for (const RingWord& word : testing::drained(board.words[0])) header.push_back(word.header);
  CHECK(testing::bits_of(header, 16) == testing::travelling(frame[0].region, {}, 0, 16));
  board.bench.edges(1);
  CHECK(board.targets[0].read() == 0);
}
