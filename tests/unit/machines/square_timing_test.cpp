#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "hw/base/error.h"
#include "hw/machines/regions.h"
#include "hw/machines/runs_on.h"
#include "hw/machines/timing.h"
#include "tests/support/random_program.h"

using namespace csgsim;
using isa::Field;
using isa::Instruction;
using isa::Opcode;
using machines::FrameTiming;
using machines::Kind;
using machines::Machine;
using machines::SquareAccount;
using machines::SquareClocks;

namespace {

/// Clocks of a part by activity: working, waiting for host, divider, renderer, frame buffer, done.
using Clocks = SquareClocks;

Machine machine_of(std::uint32_t side, machines::PixelSquare figures) {
  Machine machine;
  machine.name = "squares";
  machine.kind = Kind::pixel_square;
  machine.array = {side, side, 16};
  machine.picture = {4, 4};
  machine.pixel_square = figures;
  return machine;
}

const Instruction enable{.opcode = Opcode::enable_all};

Instruction set(Field field) { return {.opcode = Opcode::set_constant, .fields = {field}}; }

isa::Program program_of(std::uint16_t colour_bits, std::vector<isa::Segment> segments) {
  isa::Program program;
  program.shape = {4, 4, 16};
  program.fields.push_back({"colour", {0, colour_bits}, isa::FieldRole::colour});
  program.segments = std::move(segments);
  return program;
}

isa::Segment square(std::uint32_t side, std::vector<Instruction> instructions) {
  return {.region = {0, 0, side, side}, .instructions = std::move(instructions)};
}

struct Timing {
  std::uint64_t clocks = 0;
  SquareAccount account;
};

Timing time(const isa::Program& program, const Machine& machine) {
  const FrameTiming timing = machines::time_squares(program, machine);
  return {timing.clocks, std::get<SquareAccount>(timing.account)};
}

std::uint64_t sum(const SquareClocks& clocks) {
  return std::accumulate(clocks.begin(), clocks.end(), std::uint64_t{0});
}

template <class Run>
std::string error_of(Run run) {
  try {
    run();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a Program without squares takes no clock") {
  const Timing timing = time(program_of(3, {}), machine_of(2, {}));
  CHECK(timing.clocks == 0);
  CHECK(timing.account.divider == Clocks{});
}

TEST_CASE("a square that nothing touches is cleared in the clock after the divider has found so") {
  const Timing timing = time(program_of(3, {square(2, {})}), machine_of(2, {}));
  CHECK(timing.clocks == 2);
  CHECK(timing.account.squares_skipped == 1);
  CHECK(timing.account.divider == Clocks{1, 0, 0, 0, 0, 1});
  CHECK(timing.account.frame_buffer == Clocks{1, 0, 0, 1, 0, 0});
  CHECK(timing.account.renderers == std::vector<Clocks>{{0, 0, 0, 0, 0, 2}});
}

TEST_CASE("the divider tests when the model's last word has come") {
  // Words leave at 1, 2, 3 and are taken at 2, 3, 4; 2 * 1 + 1 * 4 clocks of tests at 5 to 10, the clear at 11, 12.
  isa::Program program = program_of(3, {square(2, {})});
  program.model.primitives = 2;
  program.model.halfspaces = 1;
  program.segments[0].halfspaces = 1;
  const Timing timing = time(program, machine_of(2, {.fifo_depth = 4, .primitive_clocks = 1, .halfspace_clocks = 4}));
  CHECK(timing.clocks == 12);
  CHECK(timing.account.host == Clocks{3, 0, 0, 0, 0, 9});
  CHECK(timing.account.divider == Clocks{3 + 6 + 1, 1, 0, 0, 0, 1});
}

TEST_CASE("one place between host and divider takes a word every other clock") {
  // Words leave at 1, 3, 5 and are taken at 2, 4, 6; no tests, the clear at 7, 8.
  isa::Program program = program_of(3, {square(2, {})});
  program.model.halfspaces = 3;
  const Timing timing = time(program, machine_of(2, {.fifo_depth = 1}));
  CHECK(timing.clocks == 8);
  CHECK(timing.account.host == Clocks{3, 0, 2, 0, 0, 3});
  CHECK(timing.account.divider == Clocks{3 + 1, 3, 0, 0, 0, 1});
}

TEST_CASE("a slow host's word leaves in the last of its clocks") {
  // At 3 and 6, taken at 4 and 7; the clear at 8, 9.
  isa::Program program = program_of(3, {square(2, {})});
  program.model.halfspaces = 2;
  const Timing timing = time(program, machine_of(2, {.fifo_depth = 1, .host_word_clocks = 3}));
  CHECK(timing.clocks == 9);
  CHECK(timing.account.host == Clocks{6, 0, 0, 0, 0, 3});
}

TEST_CASE("instructions follow back to back, the end word takes the trees' latency, the colours leave word by word") {
  // Words leave the divider at 1, 2, 3. The pixels' instructions begin at 2 and 3 (three clocks); the end word is taken
  // at 6 and arrives at 8. 12 colour bits leave at 9, 10, 11 and are stored at 10, 11, 12.
  const isa::Program program = program_of(3, {square(2, {enable, set({0, 3})})});
  for (const std::uint32_t buffers : {1U, 2U}) {
    const Timing timing = time(program, machine_of(2, {.buffers = buffers, .fifo_depth = 8, .port_bits = 5}));
    CHECK(timing.clocks == 12);
    CHECK(timing.account.squares_drawn == 1);
    CHECK(timing.account.divider == Clocks{3, 0, 0, 0, 0, 9});
    const Clocks one_buffer{1 + 3 + 3, 0, 1, 0, 3, 1};
    const Clocks two_buffers{1 + 3 + 3, 0, 1, 0, 0, 4};
    CHECK(timing.account.renderers == std::vector<Clocks>{buffers == 1 ? one_buffer : two_buffers});
    CHECK(timing.account.frame_buffer == Clocks{3, 0, 0, 9, 0, 0});
  }
}

TEST_CASE("one place between divider and renderer, and renderer and frame buffer, takes a word every other clock") {
  // Words leave the divider at 1, 3, 5 and are taken at 2, 4, 7; the end arrives at 9; colours leave at 10, 12, 14.
  const isa::Program program = program_of(3, {square(2, {enable, set({0, 3})})});
  const Timing timing = time(program, machine_of(2, {.buffers = 2, .fifo_depth = 1, .port_bits = 5}));
  CHECK(timing.clocks == 15);
  CHECK(timing.account.divider == Clocks{3, 0, 0, 2, 0, 10});
  CHECK(timing.account.renderers == std::vector<Clocks>{{7, 0, 2, 0, 0, 6}});
  CHECK(timing.account.frame_buffer == Clocks{3, 0, 0, 12, 0, 0});
}

TEST_CASE("a finished square waits until the one before it has left the output buffer") {
  // The first is drawn at 3 and leaves at 4 to 7, the second is drawn at 5, moves at 8 and leaves at 9 to 12.
  const isa::Program program = program_of(4, {square(1, {enable}), square(1, {enable})});
  const Timing timing = time(program, machine_of(1, {.buffers = 2, .fifo_depth = 8, .port_bits = 1}));
  CHECK(timing.clocks == 13);
  CHECK(timing.account.renderers == std::vector<Clocks>{{4, 0, 1, 0, 3, 5}});
  CHECK(timing.account.frame_buffer == Clocks{8, 0, 0, 5, 0, 0});
}

TEST_CASE("with one buffer the next square begins when the last word of the one before has left") {
  // The first is drawn at 3 and leaves at 4 to 7; the second is taken at 8 and 9 and leaves at 10 to 13.
  const isa::Program program = program_of(4, {square(1, {enable}), square(1, {enable})});
  const Timing timing = time(program, machine_of(1, {.buffers = 1, .fifo_depth = 8, .port_bits = 1}));
  CHECK(timing.clocks == 14);
  CHECK(timing.account.renderers == std::vector<Clocks>{{4, 0, 1, 0, 8, 1}});
}

TEST_CASE(
    "a square goes to the renderer with the fewest squares unfinished, and the divider hears of it a clock later") {
  // Without latency the first square is finished at 3, which the divider does not know at 3: the second goes to
  // renderer 1, and the third, at 5, to renderer 0.
  const isa::Program program = program_of(2, {square(1, {enable}), square(1, {enable}), square(1, {enable})});
  const Timing timing = time(program, machine_of(1, {.renderers = 2, .buffers = 2, .fifo_depth = 8, .port_bits = 2}));
  CHECK(timing.account.renderer_squares == std::vector<std::uint64_t>{2, 1});
  CHECK(timing.clocks == 9);
}

TEST_CASE("renderers take turns at the frame buffer, word by word") {
  // Renderer 0 has eight words from 4 on, renderer 1 four from 6 on: 0 is served at 5 and 6, then both in turn.
  isa::Program program = program_of(4, {square(2, {enable}), square(1, {enable})});
  const Timing timing = time(program, machine_of(2, {.renderers = 2, .buffers = 2, .fifo_depth = 32, .port_bits = 1}));
  // Drawn at 3 + 2 and 5 + 2. Sixteen words from 6 on, four from 8 on; every clock from 7 on stores one.
  CHECK(timing.clocks == 6 + 16 + 4);
  CHECK(timing.account.frame_buffer == Clocks{20, 0, 0, 6, 0, 0});
}

TEST_CASE("all squares are drawn and every clock is accounted for, whatever the depth of the FIFOs") {
  CHECK(rc::check([] {
    const auto pick = [](std::uint32_t least, std::uint32_t most) {
      return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(least, most + 1));
    };
    Machine machine = machine_of(pick(1, 6), {.renderers = pick(1, 4),
                                              .buffers = pick(1, 2),
                                              .fifo_depth = *rc::gen::element(1U, 2U, 3U, 7U, 1000U),
                                              .port_bits = pick(1, 30),
                                              .host_word_clocks = pick(1, 3),
                                              .primitive_clocks = pick(0, 2),
                                              .halfspace_clocks = pick(0, 4)});
    machine.picture = {pick(1, 12), pick(1, 12)};
    const isa::Program program = *test::arbitrary_program_in_parts(machine, 8);
    const auto touched = std::count_if(program.segments.begin(), program.segments.end(),
                                       [](const isa::Segment& one) { return !one.instructions.empty(); });
    const Timing timing = time(program, machine);
    RC_ASSERT(timing.account.squares_drawn == static_cast<std::uint64_t>(touched));
    RC_ASSERT(timing.account.squares_drawn + timing.account.squares_skipped == program.segments.size());
    std::vector<SquareClocks> parts = timing.account.renderers;
    parts.insert(parts.end(), {timing.account.host, timing.account.divider, timing.account.frame_buffer});
    for (const SquareClocks& part : parts) RC_ASSERT(sum(part) == timing.clocks);
  }));
}

TEST_CASE("a machine that works on parts of the picture refuses questions, and says what to do") {
  isa::Program program = program_of(2, {square(1, {enable, {.opcode = Opcode::global_or}})});
  Machine machine = machine_of(1, {});
  for (const Kind kind : {Kind::scan_line, Kind::pixel_square}) {
    machine.kind = kind;
    CHECK(error_of([&] { machines::check_runs_on(program, machine); }) ==
          "segment 0, instruction 1: global_or needs a global OR, which the machine squares does not have; compile the "
          "model for this machine, or take one of kind frame-buffer whose global_or.present is 1");
  }
  machine.kind = Kind::frame_buffer;
  CHECK_NOTHROW(machines::check_runs_on(program, machine));
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

TEST_CASE("a model whose clocks would not fit their counter is refused") {
  isa::Program program = program_of(2, {square(1, {})});
  program.model.primitives = ~std::uint64_t{0};
  program.model.halfspaces = 1;
  CHECK(error_of([&] {
          machines::time_squares(program, machine_of(1, {}));
        }).starts_with("a model of 18446744073709551615"));
  program.model.primitives = std::uint64_t{1} << 32U;
  program.segments.assign(1 << 11, square(1, {}));
  CHECK(error_of([&] {
          machines::time_squares(program, machine_of(1, {.primitive_clocks = 1'000'000}));
        }).starts_with("the divider would test for more than"));
}
