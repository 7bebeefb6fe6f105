#include <rapidcheck.h>

#include "hw/isa/host_counts.h"
#include "hw/isa/operands.h"
#include "hw/isa/wire.h"
#include "hw/machines/clocks.h"
#include "tests/support/random_program.h"
#include "tests/support/test.h"
#include "tests/unit/machines/square_timing.h"

using namespace csgsim;
using namespace csgsim::testing::squares;
using pixel_square::SquareClocks;

namespace {

std::uint32_t pick(std::uint32_t least, std::uint32_t most) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(least, most + 1));
}

Machine any_machine() {
  Machine machine = make_machine(pick(1, 6),
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

std::uint64_t arriving_words(std::uint64_t bits, std::uint64_t width) { return (bits + width - 1) / width; }

/// Returns any_machine() with a divider whose tests take random clocks.
Machine any_dividing_machine() {
  Machine machine = any_machine();
  auto& figures = machines::kind_figures<Figures>(machine);
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

/// Returns a Program for the machine with random tests.
isa::Program any_divided_program(const Machine& machine) {
  isa::Program program = *test::arbitrary_program_in_parts(machine, 8);
  program.display_model = model_bytes();
  for (isa::Segment& one : program.segments) {
    *one.division = {.steps = {{.boxes = pick(0, 9),
                                .lists = pick(0, 9),
                                .halfspaces = pick(0, 9),
                                .cells = pick(0, 9),
                                .nodes = pick(0, 9),
                                .instructions = one.instructions.size()}}};
  }
  return program;
}

/// Clocks of a divider between the model's last word and its own last one.
std::uint64_t dividing_clocks(const isa::Program& program, const Machine& machine) {
  const auto& figures = machines::kind_figures<Figures>(machine);
  constexpr std::uint64_t nodes = 3;
  std::uint64_t clocks = nodes * figures.node_clocks;
  for (const isa::Segment& one : program.segments) {
    const isa::DivisionStep& tests = one.division->steps.front();
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

/// Clocks of each part's work in a frame, without waits for other parts.
struct Work {
  std::uint64_t host = 0;
  std::uint64_t renderers = 0;  ///< all together, including the clocks in which their squares leave
  std::uint64_t frame_buffer = 0;
};

Work work_of(const isa::Program& program, const Machine& machine) {
  const auto& figures = machines::kind_figures<Figures>(machine);
  const std::uint64_t colour_bits = isa::frame_header(program).colour.width;
  const std::uint64_t header = arriving_words(64, figures.port_bits);
  Work work{.host = machine.link.latency};
  for (const isa::Segment& one : program.segments) {
    const std::uint64_t leaving =
        header + arriving_words(colour_bits * one.region.width * one.region.height, figures.port_bits);
    work.frame_buffer += leaving;
    std::uint64_t words = one.instructions.empty() ? header : 0;
    if (words == 0) {
      words = isa::wire_words(isa::SegmentStart{one.region}, machine.link.width) +
              isa::wire_words(isa::SegmentEnd{}, machine.link.width);
      for (const Instruction& instruction : one.instructions) words += isa::wire_words(instruction, machine.link.width);
      work.renderers += std::max(machine.clear_clocks, 1U) + machines::clocks(one.instructions, machine) + 1 +
                        machines::evaluator_latency(machine) + leaving + 2;
      if (figures.buffers == 2 && figures.move_bits > 0)
        work.renderers += arriving_words(colour_bits, figures.move_bits);
    }
    work.host += words * machine.link.word_clocks;
  }
  return work;
}

/// Ensures that every square has instructions, so that none is cleared.
void draw_everywhere(isa::Program& program) {
  for (isa::Segment& one : program.segments) {
    if (one.instructions.empty()) one.instructions.push_back(enable);
  }
}

/// Returns the clocks after a change of the machine's figures.
template <class Change>
std::uint64_t clocks_with(const Change& change, const isa::Program& program, Machine machine) {
  change(machine, machines::kind_figures<Figures>(machine));
  return time(program, machine).clocks;
}

}  // namespace

TEST_CASE("a frame takes at least its busiest part's work and at most the sum of all work") {
  CHECK(rc::check([] {
    const Machine machine = any_machine();
    const isa::Program program = *test::arbitrary_program_in_parts(machine, 8);
    const Work work = work_of(program, machine);
    const std::uint64_t clocks = time(program, machine).clocks;
    RC_ASSERT(clocks > std::max(work.host, work.frame_buffer));
    // Between two parts a word waits for the next edge; with a FIFO of one place the next word waits as well.
    RC_ASSERT(clocks <= 2 * work.host + work.renderers + 2 * work.frame_buffer + 4 * program.segments.size() + 4);
  }));
}

// If squares are cleared, the order in which the frame buffer serves its two ports depends on arrival: a faster part
// may deliver a clear before a square's last words and cost some clocks.
TEST_CASE("with one renderer and no clears no faster part or deeper FIFO adds clocks") {
  CHECK(rc::check([] {
    Machine machine = any_machine();
    machines::kind_figures<Figures>(machine).renderers = 1;
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

TEST_CASE("with a divider a frame lies between its busiest part's and all parts' work") {
  CHECK(rc::check([] {
    const Machine machine = any_dividing_machine();
    const isa::Program program = any_divided_program(machine);
    const std::uint64_t model = arriving_words(8 * program.display_model.size(), machine.link.width);
    const std::uint64_t host = machine.link.latency + model * machine.link.word_clocks;
    // The words of the squares enter the store and leave it, one per clock; an empty square takes one word.
    Machine sending = machine;
    sending.link.latency = 0;
    sending.link.word_clocks = 1;
    const Work work = work_of(program, sending);
    std::uint64_t stored = 0;
    std::uint64_t headers = 0;
    for (const isa::Segment& one : program.segments) {
      const bool is_clear = one.instructions.empty();
      stored += is_clear ? 1 : 0;
      headers += is_clear ? arriving_words(64, machines::kind_figures<Figures>(machine).port_bits) : 0;
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

TEST_CASE("with a divider and one renderer and no clears no faster test or part adds clocks") {
  CHECK(rc::check([] {
    Machine machine = any_dividing_machine();
    machines::kind_figures<Figures>(machine).renderers = 1;
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

// Beyond two renderers, one more may change the assignment: a square goes to the renderer with the fewest
// squares, not to the first free one.
TEST_CASE("more renderers never add clocks if the divider never waits for room") {
  CHECK(rc::check([] {
    Machine machine = any_dividing_machine();
    machine.link.fifo_depth = 1000;
    machines::kind_figures<Figures>(machine).port_fifo_depth = 1000;
    isa::Program program = any_divided_program(machine);
    draw_everywhere(program);
    Machine alone = machine;
    machines::kind_figures<Figures>(alone).renderers = 1;
    RC_ASSERT(time(program, machine).clocks <= time(program, alone).clocks);
  }));
}

TEST_CASE("all squares are drawn and all clocks are accounted for at any FIFO depth") {
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

TEST_CASE("on a ring all squares are drawn and the number of words is that of the links") {
  CHECK(rc::check([] {
    Machine machine = any_machine();
    Figures& figures = machines::kind_figures<Figures>(machine);
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
    // Commands, headers and colours travel once each, on links or on the ring.
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
