#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <initializer_list>
#include <numeric>
#include <string>
#include <vector>

#include "hw/base/error.h"
#include "hw/division/encoding.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"
#include "hw/isa/wire.h"
#include "hw/machines/clocks.h"
#include "hw/machines/regions.h"
#include "hw/machines/runs_on.h"
#include "hw/pixel_planes/kind.h"
#include "hw/pixel_square/figures.h"
#include "hw/pixel_square/kind.h"
#include "hw/pixel_square/timing.h"
#include "hw/pixel_square/timing_division.h"
#include "hw/scan_line/kind.h"
#include "tests/support/error_of.h"
#include "tests/support/random_program.h"
#include "tests/unit/division/hand_models.h"

using namespace csgsim;
using isa::Field;
using isa::Instruction;
using isa::Opcode;
using machines::Machine;
using pixel_square::Figures;
using pixel_square::SquareClocks;
using Timing = pixel_square::SquareTiming;

using testing::error_of;

namespace {

/// Clocks of a part by activity: working, waiting for host, divider, renderer, frame buffer, done.
using Clocks = SquareClocks;

/// A link whose every command here is a word.
constexpr machines::Link wide{.width = 256, .word_clocks = 1, .fifo_depth = 1000, .latency = 0};

Machine machine_of(std::uint32_t side, Figures figures, machines::Link link = wide) {
  Machine machine = machines::blank(pixel_square::kind);
  machine.name = "squares";
  machine.array = {side, side, 16};
  machine.picture = {4, 4};
  machine.link = link;
  machine.own = figures;
  return machine;
}

const Instruction enable{.opcode = Opcode::enable_all};

Instruction set(Field field) { return {.opcode = Opcode::set_constant, .fields = {field}}; }

isa::Program program_of(std::uint16_t colour_bits, std::vector<isa::Segment> segments) {
  isa::Program program;
  program.shape = {4, 4, 16};
  program.colour = {0, colour_bits};
  program.segments = std::move(segments);
  return program;
}

isa::Segment square(std::uint32_t side, std::vector<Instruction> instructions) {
  return {.region = {0, 0, side, side}, .instructions = std::move(instructions)};
}

Timing time(const isa::Program& program, const Machine& machine) {
  return pixel_square::time_squares(program, machine);
}

}  // namespace

TEST_CASE("a Program without squares takes no clock") {
  const Timing timing = time(program_of(3, {}), machine_of(2, {}));
  CHECK(timing.clocks == 0);
  CHECK(timing.account.host == Clocks{});
}

TEST_CASE("a square that nothing touches costs its header and the words of its background") {
  // Eight words of header leave at 1 to 8 and are taken at 2 to 9; 12 bits are cleared at 10 and 11.
  const isa::Program program = program_of(3, {square(2, {})});
  const Timing timing = time(program, machine_of(2, {.port_bits = 8, .port_fifo_depth = 8}));
  CHECK(timing.clocks == 11);
  CHECK(timing.account.squares_skipped == 1);
  CHECK(timing.account.host == Clocks{8, 0, 0, 0, 0, 3});
  CHECK(timing.account.frame_buffer == Clocks{10, 0, 0, 1, 0, 0});
  CHECK(timing.account.renderers == std::vector<Clocks>{{0, 0, 0, 0, 0, 11}});
}

TEST_CASE("a cleared square of Pixel-planes 5 keeps a port of 32 bits busy for 12,288 clocks") {
  isa::Program program = program_of(24, {square(128, {})});
  program.shape = {128, 128, 208};
  const Timing timing = time(program, machine_of(128, {.port_bits = 32, .port_fifo_depth = 2}));
  CHECK(timing.clocks == 1 + 2 + 12'288);
}

TEST_CASE("a slow host's word leaves in the last of its clocks, after the latency") {
  // At 4 + 3; it is taken at 8, and one word of background is written at 9.
  const isa::Program program = program_of(3, {square(2, {})});
  const Timing timing =
      time(program, machine_of(2, {.port_bits = 64}, {.width = 256, .word_clocks = 3, .fifo_depth = 1, .latency = 4}));
  CHECK(timing.clocks == 9);
  CHECK(timing.account.host == Clocks{3, 4, 0, 0, 0, 2});
}

namespace {

/// A model of two primitives and three nodes. By docs/division.md its records have 77 bits (a primitive), 6 (a
/// half-space) and 8 (a plane).
std::vector<std::uint8_t> model_bytes() {
  std::vector<std::uint8_t> bytes;
  for (const isa::LinkWord& byte : division::to_link(division::encode(testing::slab_with_hole()), 8))
    bytes.push_back(static_cast<std::uint8_t>(byte.number(0, 8)));
  return bytes;
}

/// Through a port of 80 bits each record takes a clock.
Figures dividing() {
  return {.port_bits = 64,
          .divider = pixel_square::DividerKind::corners,
          .model_bits = 1'000'000,
          .record_bits = 80,
          .halfspaces = 1000,
          .nodes = 1000,
          .store_words = 1000,
          .halfspace_clocks = 4};
}

}  // namespace

TEST_CASE("a divider takes the model, tests a square, and then it is sent") {
  isa::Program program = program_of(3, {square(2, {})});
  program.display_model = model_bytes();
  program.segments[0].division = {.steps = {{.boxes = 2, .lists = 1, .halfspaces = 3, .cells = 5, .nodes = 7}}};
  const Machine machine = machine_of(2, dividing());
  // Of two words of 256 bits the last is taken at 3. A clock for each node of the tree; each box is read and tested in
  // two; a half-space is read, with its plane, in two clocks and tested in four: fourteen for three. Then cells, nodes
  // and the word that nothing is seen.
  REQUIRE(program.display_model.size() > 32);
  REQUIRE(program.display_model.size() <= 64);
  constexpr std::uint64_t stored = 3 + 3 + 2 * 2 + 14 + 5 + 7 + 1;
  const Timing timing = time(program, machine);
  // The header leaves a clock later, is taken after another one, and then a word of background is written.
  CHECK(timing.clocks == stored + 3);
  CHECK(timing.account.host == Clocks{2, 0, 0, 0, 0, stored + 1});
  CHECK(timing.account.dividers == std::vector<Clocks>{{stored - 1, 1, 0, 0, 0, 3}});
  CHECK(timing.account.sender == Clocks{1, 0, stored, 0, 0, 2});
}

TEST_CASE("half-spaces, nodes and planes that a divider's memories do not hold cost clocks, each its own") {
  isa::Program program = program_of(3, {square(2, {})});
  program.display_model = model_bytes();
  program.segments[0].division = {.steps = {{.boxes = 1, .lists = 1, .halfspaces = 3, .cells = 5, .nodes = 7}}};
  const auto clocks = [&](const auto& change) {
    Machine machine = machine_of(2, dividing());
    machine.link.latency = 6;
    change(machines::own<Figures>(machine));
    return time(program, machine).clocks;
  };
  const std::uint64_t fits = clocks([](Figures&) {});
  // An entry of 251 bits and 15 places among 2 has 266, four words of 80: one is written, and five cells read.
  CHECK(clocks([](Figures& own) { own.halfspaces = 2; }) == fits + (1 + 5) * 4);
  // Two nodes of 98 bits are written and read, in two words each.
  CHECK(clocks([](Figures& own) { own.nodes = 5; }) == fits + 2 * 2 * 2);
  // A plane comes over the link in 6 + 1 clocks: with the half-space's own that is 8 in place of 4, and 4 in place
  // of 2.
  CHECK(clocks([](Figures& own) { own.model_bits = 8; }) == fits + 3 * (8 - 4) + (4 - 2));
}

TEST_CASE("a square begins to leave when all of it is stored, or when no more of it fits") {
  isa::Program program = program_of(3, {square(2, {enable, enable, enable})});
  program.display_model = model_bytes();
  program.segments[0].division = {.steps = {{.boxes = 100, .instructions = 2}, {.boxes = 100, .instructions = 1}}};
  const auto time_with = [&](std::uint32_t words) {
    Machine machine = machine_of(2, dividing());
    machines::own<Figures>(machine).store_words = words;
    return time(program, machine);
  };
  // SegmentStart, two instructions; 200 clocks of boxes; an instruction, SegmentEnd. With room for three words the
  // first three leave while the second surface is tested.
  const Timing whole = time_with(5);
  const Timing parts = time_with(3);
  CHECK(whole.account.sender.value().of(pixel_square::SquareActivity::working) == 5);
  CHECK(parts.account.sender.value().of(pixel_square::SquareActivity::working) == 5);
  const auto working = [](const Timing& timing) {
    return timing.account.dividers.front().of(pixel_square::SquareActivity::working);
  };
  CHECK(working(whole) == working(parts));
  // Clearing and drawing of the first two instructions are over when the third comes.
  CHECK(parts.clocks < whole.clocks);
  // With room for one word each waits for the one before to leave, which takes a clock more.
  CHECK(time_with(1).account.dividers.front().of(pixel_square::SquareActivity::waiting_for_renderer) > 0);
}

TEST_CASE("two dividers halve the time of tests that bound a frame, and take squares in turn") {
  isa::Program program = program_of(3, std::vector<isa::Segment>(4, square(2, {})));
  program.display_model = model_bytes();
  for (std::uint32_t i = 0; i < 4; ++i) {
    program.segments[i].region = {2 * (i % 2), i / 2 * 2, 2, 2};
    program.segments[i].division = {.steps = {{.boxes = 500}}};
  }
  Machine machine = machine_of(2, dividing());
  const std::uint64_t one = time(program, machine).clocks;
  machines::own<Figures>(machine).dividers = 2;
  const Timing timing = time(program, machine);
  CHECK(timing.account.dividers.size() == 2);
  // The last two squares come together: the second's header waits a clock, and so does its background.
  CHECK(one - timing.clocks == 2 * (500 * 2 + 1) - 2);
}

TEST_CASE("tests whose clocks would not fit their counter are refused") {
  isa::Program program = program_of(2, {square(1, {})});
  program.display_model.resize(1);
  program.segments[0].division.steps = {{.cells = ~std::uint64_t{0}}};
  CHECK(error_of([&] {
          pixel_square::check_countable(program, machine_of(1, {}));
        }).starts_with("the divider would test for more than"));
  program.segments[0].division.steps = {{.cells = std::uint64_t{1} << 36U}};
  program.segments.assign(1 << 5, program.segments[0]);
  CHECK_NOTHROW(pixel_square::check_countable(program, machine_of(1, {})));
  CHECK(error_of([&] {
          pixel_square::check_countable(program, machine_of(1, {.cell_clocks = 1'000'000}));
        }).starts_with("the divider would test for more than"));
}

namespace {

Figures on_a_ring(Figures figures) {
  figures.divider = pixel_square::DividerKind::processors;
  return figures;
}

}  // namespace

TEST_CASE("on a ring a header is carried in the last of its clocks, and stored a clock later") {
  // Eight words of header are sent at 1 to 8. They are carried at 3, 6, ... 24, and taken at 4, 7, ... 25; 12 bits are
  // cleared at 26 and 27.
  const isa::Program program = program_of(3, {square(2, {})});
  const Figures figures = on_a_ring({.port_fifo_depth = 8, .ring_bits = 8, .ring_word_clocks = 3});
  const Timing timing = time(program, machine_of(2, figures));
  CHECK(timing.clocks == 27);
  CHECK(timing.account.squares_skipped == 1);
  CHECK(timing.account.processors == std::vector<Clocks>{{8, 0, 0, 0, 0, 3, 0, 16}});
  REQUIRE(timing.account.ring);
  CHECK(timing.account.ring->clocks == Clocks{24, 0, 3});
  CHECK(timing.account.ring->words == 8);
  CHECK(timing.account.ring->full_clocks == 24);
  CHECK(timing.account.frame_buffer == Clocks{10, 0, 0, 17});
}

TEST_CASE("on a ring a square's commands and its colours each take a clock more than over links") {
  // Words leave the processor at 1 to 4, are carried at 2 to 5, and the decoder takes them at 3 to 6; all the rest is a
  // clock later than over a link. Words of the square leave at 12, 13, 14, are carried a clock later, and stored
  // another one later.
  const isa::Program program = program_of(3, {square(2, {enable, set({0, 3})})});
  Machine machine = machine_of(2, on_a_ring({.buffers = 2, .port_fifo_depth = 8, .ring_bits = 32}));
  machine.link.width = 1;
  const Timing wide_words = time(program, machine);
  machines::own<Figures>(machine).ring_bits = 256;
  machines::own<Figures>(machine).port_bits = 1;
  const Timing timing = time(program, machine);
  // A header and the colours in two words: they leave at 12 and 13.
  CHECK(timing.clocks == 15);
  CHECK(timing.account.renderers == std::vector<Clocks>{{8, 0, 3, 0, 0, 4}});
  CHECK(timing.account.processors == std::vector<Clocks>{{4, 0, 0, 0, 0, 10, 0, 1}});
  // In words of 32 bits the region takes three, and so the header one more and the start two.
  CHECK(wide_words.clocks == timing.clocks + 2 + 1);
}

TEST_CASE("two processors feed two renderers at once, and one renderer by turns") {
  // A square takes three words. Over the ring both come at once; to one renderer the second begins when the last word
  // of the first has been carried, at 4, so that its words are carried at 6, 7, 8.
  const isa::Program program = program_of(1, {square(1, {enable}), square(1, {enable})});
  const auto account = [&](std::uint32_t renderers) {
    return time(program, machine_of(1, on_a_ring({.renderers = renderers,
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

TEST_CASE("words of two sources for one place wait for each other, and so do more than there are channels") {
  // Three squares to clear, a word of header and one of background each. Their headers are carried at 2, or one a
  // clock.
  const isa::Program program = program_of(1, {square(1, {}), square(1, {}), square(1, {})});
  const auto clocks = [&](std::uint32_t channels, std::uint32_t banks) {
    Figures figures = on_a_ring({.port_fifo_depth = 8, .banks = banks, .processors = 3, .ring_bits = 64});
    figures.ring_channels = channels;
    return time(program, machine_of(1, figures)).account.ring.value().clocks.of(pixel_square::SquareActivity::working);
  };
  CHECK(clocks(pixel_square::all_channels, 3) == 1);
  CHECK(clocks(2, 3) == 2);
  CHECK(clocks(1, 3) == 3);
  CHECK(clocks(3, 1) == 3);
}

TEST_CASE("commands follow back to back, the end takes the trees' latency, header and colours leave word by word") {
  // Words leave the host at 1, 2, 3, 4 and the decoder takes them at 2, 3, 4, 5. The pixels' controller starts the
  // square at 3, the instructions at 4 and 5 (three clocks), the end at 8, which arrives at 10. Two words of header and
  // one of colours leave at 11, 12, 13 and are stored at 12, 13, 14.
  const isa::Program program = program_of(3, {square(2, {enable, set({0, 3})})});
  for (const std::uint32_t buffers : {1U, 2U}) {
    const Timing timing = time(program, machine_of(2, {.buffers = buffers, .port_bits = 32, .port_fifo_depth = 8}));
    CHECK(timing.clocks == 14);
    CHECK(timing.account.squares_drawn == 1);
    CHECK(timing.account.host == Clocks{4, 0, 0, 0, 0, 10});
    const Clocks one_buffer{1 + 1 + 3 + 3, 0, 2, 0, 3, 1};
    const Clocks two_buffers{1 + 1 + 3 + 3, 0, 2, 0, 0, 4};
    CHECK(timing.account.renderers == std::vector<Clocks>{buffers == 1 ? one_buffer : two_buffers});
    CHECK(timing.account.frame_buffer == Clocks{3, 0, 0, 11, 0, 0});
  }
}

TEST_CASE("bit planes move to the second buffer a few a clock, and memory is cleared before the first instruction") {
  // As above, but three planes take two clocks, and the start takes five.
  const isa::Program program = program_of(3, {square(2, {enable, set({0, 3})})});
  Machine machine = machine_of(2, {.buffers = 2, .move_bits = 2, .port_bits = 32, .port_fifo_depth = 8});
  CHECK(time(program, machine).clocks == 16);
  machine.clear_clocks = 5;
  const Timing timing = time(program, machine);
  CHECK(timing.clocks == 20);
  CHECK(timing.account.renderers == std::vector<Clocks>{{5 + 1 + 3 + 3 + 2, 0, 2, 0, 0, 4}});
}

TEST_CASE("a command of several words is obeyed when the last has come") {
  // The region of 70 bits takes three words, which the decoder takes at 2, 3, 4.
  const isa::Program program = program_of(3, {square(2, {enable, set({0, 3})})});
  Machine machine = machine_of(2, {.buffers = 2, .port_bits = 32, .port_fifo_depth = 8});
  machine.link.width = 32;
  const Timing timing = time(program, machine);
  CHECK(timing.clocks == 16);
  CHECK(timing.account.renderers == std::vector<Clocks>{{8, 0, 4, 0, 0, 4}});
}

TEST_CASE("a question waits for its answer, and each instruction that it skips takes a clock to be dropped") {
  // The question is obeyed at 4, and its answer is there at 7. Then the instructions are dropped, the first at 7, and
  // the end is obeyed in the clock after the last; each word of it takes as long as above.
  const Instruction question{.opcode = Opcode::skip_if_none, .constant = 1};
  const machines::Skip none{.segment = 0, .index = 0};
  Machine machine = machine_of(2, {.buffers = 2, .port_bits = 32, .port_fifo_depth = 8, .has_global_or = true});
  for (std::uint64_t skipped = 1; skipped <= 3; ++skipped) {
    std::vector<Instruction> instructions(1 + skipped, set({0, 3}));
    instructions[0] = question;
    instructions[0].constant = skipped;
    const isa::Program program = program_of(3, {square(2, std::move(instructions))});
    CHECK(pixel_square::time_squares(program, machine, {{none}}).clocks == 14 + skipped - 1);
    CHECK(time(program, machine).clocks == 13 + 3 * skipped);
  }
  machines::own<Figures>(machine).or_fan_in = 2;
  const isa::Program program = program_of(3, {square(2, {question, set({0, 3})})});
  CHECK(pixel_square::time_squares(program, machine, {{none}}).clocks == 14 + 2);
  CHECK(machines::clocks(question, machine) == 1 + 2 + 2);
}

TEST_CASE("one place between host and renderer, and renderer and frame buffer, takes a word every other clock") {
  // Words leave the host at 1, 3, 5, 7 and are taken at 2, 4, 6, 8; the end is obeyed at 10 and arrives at 12; words
  // of the square leave at 13, 15, 17.
  const isa::Program program = program_of(3, {square(2, {enable, set({0, 3})})});
  Machine machine = machine_of(2, {.buffers = 2, .port_bits = 32});
  machine.link.fifo_depth = 1;
  const Timing timing = time(program, machine);
  CHECK(timing.clocks == 18);
  CHECK(timing.account.host == Clocks{4, 0, 0, 3, 0, 11});
  CHECK(timing.account.renderers == std::vector<Clocks>{{8, 0, 4, 0, 0, 6}});
  CHECK(timing.account.frame_buffer == Clocks{3, 0, 0, 15, 0, 0});
}

TEST_CASE("a finished square waits until the one before it has left the output buffer") {
  // The first is drawn at 5 and leaves at 6 to 73, the second is drawn at 8, moves at 74 and leaves at 75 to 142.
  const isa::Program program = program_of(4, {square(1, {enable}), square(1, {enable})});
  const Timing timing = time(program, machine_of(1, {.buffers = 2, .port_bits = 1, .port_fifo_depth = 8}));
  CHECK(timing.clocks == 143);
  CHECK(timing.account.renderers == std::vector<Clocks>{{6, 0, 2, 0, 66, 69}});
  CHECK(timing.account.frame_buffer == Clocks{136, 0, 0, 7, 0, 0});
}

TEST_CASE("a backing store holds as many finished squares as its bits make, and words of one follow those of another") {
  // The first is drawn at 5. A square is 68 words; with a second buffer the next comes there a clock after the last
  // word of the one before, and leaves from the clock after that on.
  const isa::Program program = program_of(4, {square(1, {enable}), square(1, {enable}), square(1, {enable})});
  const auto time_with = [&](Figures figures) {
    figures.port_bits = 1;
    figures.port_fifo_depth = 8;
    return time(program, machine_of(1, figures));
  };
  CHECK(time_with({.buffers = 2}).clocks == 5 + 3 * 68 + 1 + 2);
  CHECK(time_with({.backing_bits = 8}).clocks == 5 + 3 * 68 + 1);
  CHECK(time_with({.backing_bits = 4}).clocks == time_with({.buffers = 2}).clocks);
  CHECK(time_with({.backing_bits = 8, .backing_width = 2}).clocks == 5 + 2 + 3 * 68 + 1);
  const auto waited = [&](std::uint32_t bits) {
    return time_with({.backing_bits = bits})
        .account.renderers.at(0)
        .of(pixel_square::SquareActivity::waiting_for_frame_buffer);
  };
  CHECK(waited(12) == 0);
  CHECK(waited(8) == 73 - 11 + 1);
  const Machine machine = machine_of(1, {.backing_bits = 3});
  isa::Program whole = program_of(4, {});
  for (const isa::Region& region : machines::regions(machine))
    whole.segments.push_back({.region = region, .instructions = {}});
  CHECK(
      error_of([&] { machines::check_runs_on(whole, machine); }) ==
      "a pixel has 4 bits of colour, and 3 of squares where finished squares wait; give backing.bits more, or 0 for a "
      "second buffer");
}

TEST_CASE("with one buffer the next square begins when the last word of the one before has left") {
  // The first is drawn at 5 and leaves at 6 to 73; the second is started at 74, ends at 76 and leaves at 77 to 144.
  const isa::Program program = program_of(4, {square(1, {enable}), square(1, {enable})});
  const Timing timing = time(program, machine_of(1, {.buffers = 1, .port_bits = 1, .port_fifo_depth = 8}));
  CHECK(timing.clocks == 145);
  CHECK(timing.account.renderers == std::vector<Clocks>{{6, 0, 2, 0, 136, 1}});
}

TEST_CASE("a square goes to the renderer with the fewest squares unfinished, which is known a clock later") {
  // The first keeps renderer 0 busy until 14; the second leaves at 7, 8, 9 and is finished at 11. Words that clear
  // leave from 10 on. The last square leaves at 11, when that is not known, or at 12.
  const isa::Segment slow = square(1, {enable, set({0, 3}), set({0, 3}), set({0, 3})});
  const isa::Segment quick = square(1, {enable});
  const isa::Segment nothing = square(1, {});
  const Machine machine = machine_of(1, {.renderers = 2, .buffers = 2, .port_bits = 64, .port_fifo_depth = 9});
  CHECK(time(program_of(2, {slow, quick, nothing, quick}), machine).account.renderer_squares ==
        std::vector<std::uint64_t>{2, 1});
  CHECK(time(program_of(2, {slow, quick, nothing, nothing, quick}), machine).account.renderer_squares ==
        std::vector<std::uint64_t>{1, 2});
}

TEST_CASE("renderers take turns at the frame buffer, word by word") {
  // Drawn at 5 + 2 and 8 + 2. Eighty words from 8 on, 68 from 11 on; every clock from 9 on stores one.
  const isa::Program program = program_of(4, {square(2, {enable}), square(1, {enable})});
  const Timing timing =
      time(program, machine_of(2, {.renderers = 2, .buffers = 2, .port_bits = 1, .port_fifo_depth = 32}));
  CHECK(timing.clocks == 8 + 80 + 68);
  CHECK(timing.account.frame_buffer == Clocks{148, 0, 0, 8, 0, 0});
}

namespace {

std::uint32_t pick(std::uint32_t least, std::uint32_t most) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(least, most + 1));
}

Machine any_machine() {
  Machine machine = machine_of(pick(1, 6),
                               {.renderers = pick(1, 4),
                                .buffers = pick(1, 2),
                                .move_bits = *rc::gen::element(0U, 1U, 2U, 5U, 32U),
                                .port_bits = pick(1, 30),
                                .port_fifo_depth = *rc::gen::element(1U, 2U, 3U, 7U, 1000U)},
                               {.width = *rc::gen::element(1U, 6U, 31U, 32U, 256U),
                                .word_clocks = pick(1, 3),
                                .fifo_depth = *rc::gen::element(1U, 2U, 3U, 7U, 1000U),
                                .latency = pick(0, 9)});
  machine.clear_clocks = *rc::gen::element(0U, 1U, 2U, 16U);
  machine.picture = {pick(1, 12), pick(1, 12)};
  return machine;
}

std::uint64_t words_in(std::uint64_t bits, std::uint64_t width) { return (bits + width - 1) / width; }

/// The same with a divider in the machine, which takes any clocks for its tests.
Machine any_dividing_machine() {
  Machine machine = any_machine();
  auto& figures = machines::own<Figures>(machine);
  const Figures own = dividing();
  figures.divider = own.divider;
  figures.model_bits = own.model_bits;
  figures.record_bits = own.record_bits;
  figures.halfspaces = own.halfspaces;
  figures.nodes = own.nodes;
  figures.store_words = *rc::gen::element(1U, 2U, 7U, 1000U);
  figures.box_clocks = pick(0, 3);
  figures.halfspace_clocks = pick(0, 5);
  figures.cell_clocks = pick(0, 3);
  figures.node_clocks = pick(0, 3);
  figures.linear_clocks = pick(0, 3);
  return machine;
}

/// A Program for it, with any tests.
isa::Program any_divided_program(const Machine& machine) {
  isa::Program program = *test::arbitrary_program_in_parts(machine, 8);
  program.display_model = model_bytes();
  for (isa::Segment& one : program.segments) {
    one.division = {.steps = {{.boxes = pick(0, 9),
                               .lists = pick(0, 9),
                               .halfspaces = pick(0, 9),
                               .cells = pick(0, 9),
                               .nodes = pick(0, 9),
                               .instructions = one.instructions.size()}}};
  }
  return program;
}

/// What a divider does between the model's last word and its own last one.
std::uint64_t dividing_clocks(const isa::Program& program, const Machine& machine) {
  const auto& figures = machines::own<Figures>(machine);
  constexpr std::uint64_t nodes = 3;
  std::uint64_t clocks = nodes * figures.node_clocks;
  for (const isa::Segment& one : program.segments) {
    const isa::DivisionStep& tests = one.division.steps.front();
    const std::uint64_t test = figures.halfspace_clocks;
    clocks += (1 + figures.box_clocks) * tests.boxes + std::max<std::uint64_t>(2, test) * tests.halfspaces +
              std::min<std::uint64_t>(2, test) * tests.lists + figures.cell_clocks * tests.cells +
              figures.node_clocks * tests.nodes;
    for (const Instruction& instruction : one.instructions)
      if (isa::has_operand(isa::operands_of(instruction.opcode), isa::OperandKind::linear))
        clocks += figures.linear_clocks;
  }
  return clocks;
}

/// What the parts of a frame have to do, apart from waiting for each other.
struct Work {
  std::uint64_t host = 0;
  std::uint64_t renderers = 0;  ///< all together, and what their squares take to leave
  std::uint64_t frame_buffer = 0;
};

Work work_of(const isa::Program& program, const Machine& machine) {
  const auto& figures = machines::own<Figures>(machine);
  const std::uint64_t colour_bits = isa::frame_header(program).colour.width;
  const std::uint64_t header = words_in(64, figures.port_bits);
  Work work{.host = machine.link.latency};
  for (const isa::Segment& one : program.segments) {
    const std::uint64_t leaving =
        header + words_in(colour_bits * one.region.width * one.region.height, figures.port_bits);
    work.frame_buffer += leaving;
    std::uint64_t words = one.instructions.empty() ? header : 0;
    if (words == 0) {
      words = isa::wire_words(isa::SegmentStart{one.region}, machine.link.width) +
              isa::wire_words(isa::SegmentEnd{}, machine.link.width);
      for (const Instruction& instruction : one.instructions) words += isa::wire_words(instruction, machine.link.width);
      work.renderers += std::max(machine.clear_clocks, 1U) + machines::clocks(one.instructions, machine) + 1 +
                        machines::evaluator_latency(machine) + leaving + 2;
      if (figures.buffers == 2 && figures.move_bits > 0) work.renderers += words_in(colour_bits, figures.move_bits);
    }
    work.host += words * machine.link.word_clocks;
  }
  return work;
}

}  // namespace

namespace {

/// No square is cleared.
void draw_everywhere(isa::Program& program) {
  for (isa::Segment& one : program.segments) {
    if (one.instructions.empty()) one.instructions.push_back(enable);
  }
}

/// Of the machine with other figures.
template <class Change>
std::uint64_t clocks_with(const Change& change, const isa::Program& program, Machine machine) {
  change(machine, machines::own<Figures>(machine));
  return time(program, machine).clocks;
}

}  // namespace

TEST_CASE("a frame takes at least what its busiest part has to do, and at most what all have to do one by one") {
  CHECK(rc::check([] {
    const Machine machine = any_machine();
    const isa::Program program = *test::arbitrary_program_in_parts(machine, 8);
    const Work work = work_of(program, machine);
    const std::uint64_t clocks = time(program, machine).clocks;
    RC_ASSERT(clocks > std::max(work.host, work.frame_buffer));
    // Between two parts a word waits for the next edge; where a FIFO has one place, the next word does as well.
    RC_ASSERT(clocks <= 2 * work.host + work.renderers + 2 * work.frame_buffer + 4 * program.segments.size() + 4);
  }));
}

// Where squares are cleared between others, the order in which the frame buffer serves its two ports depends on who
// comes first: a faster part may bring a clear before a square's last words and cost some clocks.
TEST_CASE("with one renderer, and no square cleared, no faster part and no deeper FIFO takes more clocks") {
  CHECK(rc::check([] {
    Machine machine = any_machine();
    machines::own<Figures>(machine).renderers = 1;
    isa::Program program = *test::arbitrary_program_in_parts(machine, 8);
    draw_everywhere(program);
    const std::uint64_t clocks = time(program, machine).clocks;
    const auto with = [&](const auto& change) { return clocks_with(change, program, machine); };
    RC_ASSERT(with([](Machine& one, Figures&) { ++one.link.fifo_depth; }) <= clocks);
    RC_ASSERT(with([](Machine& one, Figures&) { one.link.width = std::min(2 * one.link.width, 256U); }) <= clocks);
    RC_ASSERT(with([](Machine& one, Figures&) { one.link.word_clocks = 1; }) <= clocks);
    RC_ASSERT(with([](Machine& one, Figures&) { one.clear_clocks = 0; }) <= clocks);
    RC_ASSERT(with([](Machine&, Figures& own) { own.port_bits *= 2; }) <= clocks);
    RC_ASSERT(with([](Machine&, Figures& own) { ++own.port_fifo_depth; }) <= clocks);
    RC_ASSERT(with([](Machine&, Figures& own) { own.move_bits = 0; }) <= clocks);
  }));
}

TEST_CASE("with a divider a frame takes at least what its busiest part has to do, and at most what all have to do") {
  CHECK(rc::check([] {
    const Machine machine = any_dividing_machine();
    const isa::Program program = any_divided_program(machine);
    const std::uint64_t model = words_in(8 * program.display_model.size(), machine.link.width);
    const std::uint64_t host = machine.link.latency + model * machine.link.word_clocks;
    // The words of the squares go to the store and leave it, one a clock; where nothing is seen one says so.
    Machine sending = machine;
    sending.link.latency = 0;
    sending.link.word_clocks = 1;
    const Work work = work_of(program, sending);
    std::uint64_t stored = 0;
    std::uint64_t headers = 0;
    for (const isa::Segment& one : program.segments) {
      const bool is_clear = one.instructions.empty();
      stored += is_clear ? 1 : 0;
      headers += is_clear ? words_in(64, machines::own<Figures>(machine).port_bits) : 0;
    }
    stored += work.host - headers;
    const std::uint64_t divider = model + dividing_clocks(program, machine) + stored;
    const Timing timing = time(program, machine);
    RC_ASSERT(timing.account.dividers.size() == 1);
    RC_ASSERT(timing.account.dividers.front().of(pixel_square::SquareActivity::working) == divider);
    RC_ASSERT(timing.account.sender.value().of(pixel_square::SquareActivity::working) == work.host);
    RC_ASSERT(timing.clocks > std::max({host, divider, work.host, work.frame_buffer}));
    RC_ASSERT(timing.clocks <= 2 * host + divider + 2 * work.host + work.renderers + 2 * work.frame_buffer +
                                   4 * program.segments.size() + 4);
    for (const SquareClocks& part : {timing.account.host, timing.account.dividers.front(),
                                     timing.account.sender.value(), timing.account.frame_buffer})
      RC_ASSERT(part.total() == timing.clocks);
  }));
}

TEST_CASE("with a divider and one renderer, and no square cleared, no faster test, part or link takes more clocks") {
  CHECK(rc::check([] {
    Machine machine = any_dividing_machine();
    machines::own<Figures>(machine).renderers = 1;
    isa::Program program = any_divided_program(machine);
    draw_everywhere(program);
    const std::uint64_t clocks = time(program, machine).clocks;
    const auto with = [&](const auto& change) { return clocks_with(change, program, machine); };
    RC_ASSERT(with([](Machine&, Figures& own) { own.box_clocks = 0; }) <= clocks);
    RC_ASSERT(with([](Machine&, Figures& own) { own.halfspace_clocks /= 2; }) <= clocks);
    RC_ASSERT(with([](Machine&, Figures& own) { own.cell_clocks = 0; }) <= clocks);
    RC_ASSERT(with([](Machine&, Figures& own) { own.node_clocks /= 2; }) <= clocks);
    RC_ASSERT(with([](Machine& one, Figures&) { ++one.link.fifo_depth; }) <= clocks);
    RC_ASSERT(with([](Machine& one, Figures&) { one.link.width = std::min(2 * one.link.width, 256U); }) <= clocks);
    RC_ASSERT(with([](Machine& one, Figures&) { one.link.word_clocks = 1; }) <= clocks);
    RC_ASSERT(with([](Machine& one, Figures&) { one.link.latency = 0; }) <= clocks);
    RC_ASSERT(with([](Machine& one, Figures&) { one.clear_clocks = 0; }) <= clocks);
    RC_ASSERT(with([](Machine&, Figures& own) { own.port_bits *= 2; }) <= clocks);
    RC_ASSERT(with([](Machine&, Figures& own) { ++own.port_fifo_depth; }) <= clocks);
    RC_ASSERT(with([](Machine&, Figures& own) { own.move_bits = 0; }) <= clocks);
  }));
}

// From two renderers on, one more may change who draws what: a square goes to the one with the fewest squares, not to
// the one that is free first.
TEST_CASE("where the divider waits for no room, more renderers take no more clocks than one") {
  CHECK(rc::check([] {
    Machine machine = any_dividing_machine();
    machine.link.fifo_depth = 1000;
    machines::own<Figures>(machine).port_fifo_depth = 1000;
    isa::Program program = any_divided_program(machine);
    draw_everywhere(program);
    Machine alone = machine;
    machines::own<Figures>(alone).renderers = 1;
    RC_ASSERT(time(program, machine).clocks <= time(program, alone).clocks);
  }));
}

TEST_CASE("all squares are drawn and every clock is accounted for, whatever the depth of the FIFOs") {
  CHECK(rc::check([] {
    const Machine machine = any_machine();
    const isa::Program program = *test::arbitrary_program_in_parts(machine, 8);
    const auto touched = std::count_if(program.segments.begin(), program.segments.end(),
                                       [](const isa::Segment& one) { return !one.instructions.empty(); });
    const Timing timing = time(program, machine);
    RC_ASSERT(timing.account.squares_drawn == static_cast<std::uint64_t>(touched));
    RC_ASSERT(timing.account.squares_drawn + timing.account.squares_skipped == program.segments.size());
    std::vector<SquareClocks> parts = timing.account.renderers;
    parts.insert(parts.end(), {timing.account.host, timing.account.frame_buffer});
    for (const SquareClocks& part : parts) RC_ASSERT(part.total() == timing.clocks);
  }));
}

TEST_CASE(
    "on a ring all squares are drawn and every clock is accounted for, and as many words travel, whatever does it") {
  CHECK(rc::check([] {
    Machine machine = any_machine();
    Figures& figures = machines::own<Figures>(machine);
    figures = on_a_ring(figures);
    figures.processors = pick(1, 5);
    figures.ring_bits = pick(1, 64);
    figures.ring_word_clocks = pick(1, 3);
    figures.ring_channels = pick(0, 6);
    figures.banks = pick(1, 3);
    const isa::Program program = *test::arbitrary_program_in_parts(machine, 8);
    const Timing timing = time(program, machine);
    RC_ASSERT(timing.account.squares_drawn + timing.account.squares_skipped == program.segments.size());
    RC_ASSERT(timing.account.processors.size() == figures.processors);
    std::vector<SquareClocks> parts = timing.account.renderers;
    parts.insert(parts.end(), timing.account.processors.begin(), timing.account.processors.end());
    parts.insert(parts.end(), {timing.account.ring.value().clocks, timing.account.frame_buffer});
    for (const SquareClocks& part : parts) RC_ASSERT(part.total() == timing.clocks);
    // The words that travel are those of commands, headers and colours, each once, whatever carries them.
    figures.ring_channels = pixel_square::all_channels;
    figures.ring_word_clocks = 1;
    figures.processors = 1;
    const Timing other = time(program, machine);
    RC_ASSERT(other.account.ring.value().words == timing.account.ring.value().words);
    std::uint64_t sent = 0;
    for (const SquareClocks& one : timing.account.processors) sent += one.of(pixel_square::SquareActivity::working);
    RC_ASSERT(sent <= timing.account.ring.value().words);
  }));
}

TEST_CASE("a machine that works on parts of the picture refuses questions, and says what to do") {
  isa::Program program = program_of(2, {square(1, {enable, {.opcode = Opcode::global_or}})});
  for (const machines::Kind* const kind :
       std::initializer_list<const machines::Kind*>{&scan_line::kind, &pixel_square::kind}) {
    Machine machine = machines::blank(*kind);
    machine.name = "squares";
    CHECK(error_of([&] { machines::check_runs_on(program, machine); }) ==
          "segment 0, instruction 1: global_or needs a global OR, which the machine squares does not have; compile the "
          "model for this machine, or take one whose global_or.present is 1");
  }
  CHECK_NOTHROW(machines::check_runs_on(program, machines::blank(pixel_planes::kind)));
}

TEST_CASE(
    "renderers with an OR of their own skip, but have no answer for the host; a divider of the machine asks none") {
  isa::Program program = program_of(2, {});
  Machine machine = machine_of(2, {.has_global_or = true});
  for (const isa::Region& region : machines::regions(machine))
    program.segments.push_back({.region = region, .instructions = {}});
  program.segments[1].instructions = {{.opcode = Opcode::skip_if_none, .constant = 1}, enable};
  CHECK_NOTHROW(machines::check_runs_on(program, machine));
  CHECK(machines::has_global_or(machine));
  program.segments[1].instructions[1] = {.opcode = Opcode::global_or};
  CHECK(error_of([&] { machines::check_runs_on(program, machine); }) ==
        "segment 1, instruction 1: global_or asks for an answer to the host, to which the renderers of squares have no "
        "way back; leave it out, or take a machine of the kind frame-buffer, such as pixel-planes-4");
  machines::own<Figures>(machine).divider = pixel_square::DividerKind::corners;
  CHECK_FALSE(machines::has_global_or(machine));
}

TEST_CASE("a Program whose segments are not the machine's squares is refused") {
  const Machine machine = machine_of(2, {});
  isa::Program program = program_of(2, {});
  for (const isa::Region& region : machines::regions(machine)) {
    program.segments.emplace_back().region = region;
  }
  CHECK_NOTHROW(machines::check_runs_on(program, machine));
  std::swap(program.segments[0], program.segments[1]);
  CHECK(error_of([&] {
          machines::check_runs_on(program, machine);
        }).starts_with("the Program's segments are not the 4 regions in which squares draws a picture of 4x4"));
}
