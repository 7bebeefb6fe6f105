#include <rapidcheck.h>

#include "hw/isa/opcodes.h"
#include "hw/isa/wire.h"
#include "hw/machines/clocks.h"
#include "hw/machines/link_timing.h"
#include "hw/machines/timing.h"
#include "hw/pixel_planes/figures.h"
#include "hw/pixel_planes/kind.h"
#include "hw/pixel_planes/timing.h"
#include "tests/support/random_program.h"
#include "tests/support/test.h"

using namespace csgsim;
using isa::Instruction;
using isa::Opcode;
using machines::Machine;
using pixel_planes::ScanOutPort;

namespace {

constexpr isa::ArrayShape shape{8, 8, 40};
constexpr std::uint64_t tree_latency = 6;

Machine machine_with(const machines::Link& link, std::uint32_t clear_clocks = 0, std::uint32_t fan_in = 0) {
  Machine machine = machines::blank_machine(pixel_planes::kind);
  machine.array = shape;
  machine.link = link;
  machine.clear_clocks = clear_clocks;
  machines::kind_figures<pixel_planes::Figures>(machine).or_fan_in = fan_in;
  return machine;
}

isa::Program make_program(std::vector<Instruction> instructions) {
  isa::Program program;
  program.shape = shape;
  program.segments = {{.region = {0, 0, 8, 8}, .instructions = std::move(instructions)}};
  return program;
}

/// Returns the program with colours in the lowest bits.
isa::Program coloured(isa::Program program, std::uint32_t bits) {
  program.colour = {0, static_cast<std::uint16_t>(bits)};
  return program;
}

Machine with_buffers(Machine machine, std::uint32_t buffers, ScanOutPort port) {
  auto& figures = machines::kind_figures<pixel_planes::Figures>(machine);
  figures.scan_out_buffers = buffers;
  figures.scan_out_port = port;
  return machine;
}

std::uint64_t clocks_of(const machines::FrameTiming& timing, std::size_t part, std::string_view activity) {
  const auto& clocks = timing.account.parts[part].clocks;
  return std::find_if(clocks.begin(), clocks.end(), [&](const auto& one) { return one.activity == activity; })->clocks;
}

/// Returns jumps for a random subset of the Program's queries.
std::vector<machines::Skip> arbitrary_skips(const isa::Program& program) {
  std::vector<machines::Skip> skips;
  for (std::uint32_t s = 0; s < program.segments.size(); ++s) {
    const std::vector<Instruction>& instructions = program.segments[s].instructions;
    for (std::uint32_t i = 0; i < instructions.size(); ++i) {
      if (instructions[i].opcode != Opcode::skip_if_none || *rc::gen::arbitrary<bool>()) continue;
      skips.push_back({s, i});
      i += static_cast<std::uint32_t>(instructions[i].constant);
    }
  }
  return skips;
}

/// Random link figures and a second set that is at least as good in each.
struct Links {
  machines::Link worse;
  machines::Link better;
};

Links arbitrary_links() {
  const auto pick = [](std::uint32_t least, std::uint32_t most) {
    return *rc::gen::resize(100, rc::gen::inRange(least, most + 1));
  };
  Links links;
  links.worse = {.width = pick(1, 256), .word_clocks = pick(1, 9), .fifo_depth = pick(1, 20), .latency = pick(0, 40)};
  links.better = {.width = pick(links.worse.width, 256),
                  .word_clocks = pick(1, links.worse.word_clocks),
                  .fifo_depth = pick(links.worse.fifo_depth, 40),
                  .latency = pick(0, links.worse.latency)};
  return links;
}

/// Work of each part for the executed instructions, without waits.
struct Work {
  std::uint64_t controller = 0;  ///< clocks
  std::uint64_t words = 0;
  std::uint64_t commands = 0;
};

Work work_of(const isa::Program& program, const Machine& machine, std::span<const machines::Skip> skips) {
  Work work{.controller = tree_latency, .words = 0, .commands = 0};
  const auto add = [&](const isa::Command& command, std::uint64_t clocks) {
    work.controller += clocks;
    work.words += (isa::wire_bits(command) + machine.link.width - 1) / machine.link.width;
    ++work.commands;
  };
  for (std::uint32_t s = 0; s < program.segments.size(); ++s) {
    add(isa::SegmentStart{program.segments[s].region}, std::max(machine.clear_clocks, 1U));
    const std::vector<Instruction>& instructions = program.segments[s].instructions;
    for (std::uint32_t i = 0; i < instructions.size(); ++i) {
      add(instructions[i], machines::clocks(instructions[i], machine));
      if (std::find(skips.begin(), skips.end(), machines::Skip{s, i}) != skips.end())
        i += static_cast<std::uint32_t>(instructions[i].constant);
    }
  }
  add(isa::FrameEnd{}, 0);
  return work;
}

}  // namespace

TEST_CASE("a global OR has one level per power of its fan-in") {
  CHECK(pixel_planes::or_levels(512 * 512, 64) == 3);
  CHECK(pixel_planes::or_levels(64, 64) == 1);
  CHECK(pixel_planes::or_levels(65, 64) == 2);
  CHECK(pixel_planes::or_levels(1, 64) == 0);
  CHECK(pixel_planes::or_levels(512 * 512, 2) == 18);
  CHECK(pixel_planes::or_levels(512 * 512, 0) == 0);
}

// Hand calculation; edges count from the request at 0. The host sees it at 1. SegmentStart has 70 bits, three words of
// 32: stored at 6, 7, 8 after a latency of 4, read at 7, 8, 9. Clearing starts at 10 and takes 3 clocks. The word of
// enable_all is stored at 9 and read at 10, the edge that empties the register; the instruction starts at 13. FrameEnd
// is stored at 10, read at 13 and starts at 14; its step executes 6 clocks later.
TEST_CASE("a small frame on a frame buffer takes the hand-counted clocks") {
  const machines::FrameTiming timing =
      machines::time_frame(make_program({{.opcode = Opcode::enable_all}}),
                           machine_with({.width = 32, .word_clocks = 1, .fifo_depth = 16, .latency = 4}, 3));
  CHECK(timing.clocks == 20);
  CHECK(timing.account.count("link_words") == 5);
  CHECK(timing.account.count("link_bits") == 160);
  CHECK(clocks_of(timing, 0, "starved") == 10);
  CHECK(clocks_of(timing, 0, "clearing") == 3);
  CHECK(clocks_of(timing, 0, "issuing") == 1);
  CHECK(clocks_of(timing, 0, "draining") == 6);
  CHECK(clocks_of(timing, 1, "waiting") == 5);
  CHECK(clocks_of(timing, 1, "sending") == 5);
  CHECK(clocks_of(timing, 1, "done") == 10);
}

// Same clocks until edge 13, where the query starts: 1 clock, 6 for the trees and 2 levels of the OR. The answer is
// available at 22; the host sees it at 23, sends FrameEnd from 27 on and stores it at 28. FrameEnd is read at 29 and
// starts at 30.
TEST_CASE("a jump on a frame buffer takes the hand-counted clocks and discards words") {
  const Machine machine = machine_with({.width = 32, .word_clocks = 1, .fifo_depth = 2, .latency = 4}, 3, 8);
  const std::vector<machines::Skip> skips{{0, 0}};
  isa::Program program = make_program({{.opcode = Opcode::skip_if_none, .constant = 3},
                                       {.opcode = Opcode::enable_all},
                                       {.opcode = Opcode::enable_all},
                                       {.opcode = Opcode::enable_all}});
  const machines::FrameTiming timing = machines::time_frame(program, machine, skips);
  // The query has 38 bits, two words: stored at 9 and 10, read at 10 and 11. It starts at 13 and its bits leave the
  // register.
  CHECK(timing.clocks == 36);
  CHECK(clocks_of(timing, 0, "answering") == 8);
  CHECK(clocks_of(timing, 0, "jumping") == 8);
  CHECK(clocks_of(timing, 0, "starved") == 10);
  // Three and two words read, one in the register, two in the FIFO, and FrameEnd.
  CHECK(timing.account.count("link_words") == 3 + 2 + 1 + 2 + 1);
}

// Same clocks, but the jump target replaces FrameEnd: its word is read at 29. FrameEnd's word is stored at 29 as well.
// Three words of the segment, two of the query and three skipped words precede the jump target.
TEST_CASE("words read and sent after a jump include the skipped ones (hand calculation)") {
  const Machine machine = machine_with({.width = 32, .word_clocks = 1, .fifo_depth = 2, .latency = 4}, 3, 8);
  const std::vector<machines::Skip> skips{{0, 0}};
  std::vector<Instruction> instructions(5, {.opcode = Opcode::enable_all});
  instructions.front() = {.opcode = Opcode::skip_if_none, .constant = 3};
  const pixel_planes::Moment moment =
      pixel_planes::instruction_moment(make_program(instructions), machine, skips, 0, 4);
  CHECK(moment.clock == 30);
  CHECK(moment.words_read == 3 + 2 + 3 + 1);
  CHECK(moment.words_sent == 3 + 2 + 3 + 2);
}

TEST_CASE("at a pixel a query takes one clock and a skipped instruction none") {
  const Machine machine = machine_with({.width = 32, .word_clocks = 1, .fifo_depth = 2, .latency = 4}, 3, 8);
  const isa::Program program = make_program({{.opcode = Opcode::skip_if_none, .constant = 1},
                                             {.opcode = Opcode::enable_all},
                                             {.opcode = Opcode::skip_if_none, .constant = 1},
                                             {.opcode = Opcode::enable_all}});
  machines::Timeline timeline;
  timeline.issued = {{{13, 22}, {0, 0}, {30, 38}, {40, 43}}};
  const std::vector<machines::ClockSpan> steps = machines::spans_at_pixel(timeline, program, machine, 0, 0, 0);
  const std::uint64_t latency = machines::evaluator_latency(machine);
  REQUIRE(steps.size() == 4);
  CHECK(steps[0].begin == 13 + latency);
  CHECK(steps[0].end == 14 + latency);
  CHECK(steps[1].empty());
  CHECK(steps[2].end - steps[2].begin == 1);
  CHECK(steps[3].begin == 40 + latency);
  CHECK(steps[3].end == 43 + latency);
}

TEST_CASE("a frame takes at least the work of its busiest part and at most the total work") {
  CHECK(rc::check("a frame lies between the parallel and the sequential work of its parts", [] {
    const auto program = *test::arbitrary_program(shape, 30);
    const Machine machine =
        machine_with(arbitrary_links().worse, *rc::gen::inRange(0U, 50U), *rc::gen::element(0U, 2U, 3U, 8U, 64U));
    const auto skips = arbitrary_skips(program);
    const std::uint64_t clocks = machines::time_frame(program, machine, skips).clocks;
    const Work work = work_of(program, machine, skips);
    const std::uint64_t requests = (1 + skips.size()) * (1 + std::uint64_t{machine.link.latency});
    const std::uint64_t link = work.words * machine.link.word_clocks;
    RC_ASSERT(clocks >= work.controller);
    RC_ASSERT(clocks >= link + requests);
    RC_ASSERT(clocks <= work.controller + link + requests + work.words + work.commands);
  }));
}

TEST_CASE("a wider or faster or deeper link never adds clocks to a frame buffer's frame") {
  CHECK(rc::check("a link that is wider, faster, deeper or of lower latency adds no clock", [] {
    const auto program = *test::arbitrary_program(shape, 30);
    const auto skips = arbitrary_skips(program);
    const Links links = arbitrary_links();
    const std::uint32_t clear_clocks = *rc::gen::inRange(0U, 50U);
    const auto clocks = [&](const machines::Link& link) {
      return machines::time_frame(program, machine_with(link, clear_clocks, 8), skips).clocks;
    };
    RC_ASSERT(clocks(links.better) <= clocks(links.worse));
  }));
}

// The frame of the first case, whose FrameEnd starts at 14. Copying 5 bits takes the steps of enable_all and 5 of copy;
// the last executes 6 clocks later, at 26. With a separate port the scan-out latches a row in 5 clocks while the
// previous row is shown for 8. Counted from 27 on, it has latched the last row after 2 * 5 + 6 * 8 = 58 clocks and
// shown it after 5 + 8 * 8 = 69. The next frame also starts at 27; its picture is complete 14 clocks later, is copied
// 58 clocks later, and the frame ends at 70. The frame after it starts at 71.
TEST_CASE("a frame in two buffers is copied when its predecessor is latched (hand count)") {
  const isa::Program program = coloured(make_program({{.opcode = Opcode::enable_all}}), 5);
  const Machine machine = with_buffers(machine_with({.width = 32, .word_clocks = 1, .fifo_depth = 16, .latency = 4}, 3),
                                       2, ScanOutPort::own);
  const machines::FrameTiming alone = machines::time_frame(program, machine);
  CHECK(alone.clocks == 26);
  CHECK(alone.latency_clocks == 6);
  CHECK(alone.shown_clocks == 26 + 69);
  CHECK(alone.interval_clocks == 71);
  CHECK(clocks_of(alone, 0, "copying") == 6);
  CHECK(clocks_of(alone, 0, "holding") == 0);
  const std::vector<pixel_planes::DrawnFrame> frames(3, {&program});
  const auto sequence = pixel_planes::time_sequence(frames, machine);
  CHECK(sequence[0].interval_clocks == 27);
  CHECK(sequence[1].clocks == 70);
  CHECK(sequence[1].shown_clocks == 70 + 69);
  CHECK(clocks_of(sequence[1], 0, "holding") == 44);
  CHECK(sequence[1].interval_clocks == 71);
}

// The same with a shared port, where latching a row takes 5 + 8 clocks. The words of the first row are sent at 1 to 5
// of the second frame while the controller waits for the host. The second row starts at 13, as does enable_all; its
// words are sent at 14 to 18, and FrameEnd, which could have started at 14, starts at 19. From then on a row is latched
// every 13 clocks, the last at 103; its end is seen at 104, and the picture is copied and complete at 116.
TEST_CASE("refresh words precede the next command and fill the controller's waits") {
  const isa::Program program = coloured(make_program({{.opcode = Opcode::enable_all}}), 5);
  const Machine machine = with_buffers(machine_with({.width = 32, .word_clocks = 1, .fifo_depth = 16, .latency = 4}, 3),
                                       2, ScanOutPort::shared);
  const std::vector<pixel_planes::DrawnFrame> frames(3, {&program});
  const machines::FrameTiming second = pixel_planes::time_sequence(frames, machine)[1];
  CHECK(second.clocks == 116);
  CHECK(second.interval_clocks == 117);
  CHECK(machines::time_frame(program, machine).interval_clocks == 117);
  CHECK(clocks_of(second, 0, "starved") == 5);
  CHECK(clocks_of(second, 0, "refreshing") == 8 * 5);
  CHECK(clocks_of(second, 0, "holding") == 104 - 19 - 6 * 5);
  CHECK(clocks_of(second, 0, "copying") == 6);
  CHECK(second.account.count("refresh_waits") == 0);
}

// The clear of 40 clocks starts at 10, when the words of the first row have been sent. Those of the second row,
// requested at 13, wait from 14 until 50.
TEST_CASE("the account counts the clocks by which drawing delays the scan-out") {
  const isa::Program program = coloured(make_program({{.opcode = Opcode::enable_all}}), 5);
  const Machine machine = with_buffers(
      machine_with({.width = 32, .word_clocks = 1, .fifo_depth = 16, .latency = 4}, 40), 2, ScanOutPort::shared);
  const std::vector<pixel_planes::DrawnFrame> frames(2, {&program});
  CHECK(pixel_planes::time_sequence(frames, machine)[1].account.count("refresh_waits") == 36);
}

TEST_CASE("a second buffer delays a sequence by at most one copy and hides most scan-outs") {
  unsigned faster = 0;
  unsigned slower = 0;
  CHECK(rc::check("two buffers delay a sequence by at most one copy; no part's work exceeds the clocks", [&] {
    const auto pick = [](std::uint32_t least, std::uint32_t most) {
      return *rc::gen::resize(100, rc::gen::inRange(least, most + 1));
    };
    const std::uint32_t width = pick(1, 20);
    const isa::Program program =
        coloured(*test::arbitrary_program({shape.width, shape.height, shape.memory_bits - width}, pick(0, 60)), width);
    const auto skips = arbitrary_skips(program);
    Machine machine = machine_with(arbitrary_links().worse, pick(0, 50), *rc::gen::element(0U, 2U, 8U));
    machine.alu_bits = pick(1, 4);
    const auto port = *rc::gen::element(ScanOutPort::own, ScanOutPort::shared);
    machines::kind_figures<pixel_planes::Figures>(machine).scan_out_pixels = pick(1, 9);
    const auto one = machines::time_frame(program, with_buffers(machine, 1, port), skips);
    const auto two = machines::time_frame(program, with_buffers(machine, 2, port), skips);
    const std::uint64_t copy = 1 + (width + machine.alu_bits - 1) / machine.alu_bits;
    const std::uint64_t pixels = machines::kind_figures<pixel_planes::Figures>(machine).scan_out_pixels;
    RC_ASSERT(two.clocks == one.clocks + copy);
    RC_ASSERT(two.interval_clocks > two.clocks);
    RC_ASSERT(two.interval_clocks >= shape.height * ((shape.width + pixels - 1) / pixels));
    RC_ASSERT(two.interval_clocks >= std::uint64_t{shape.height} * width);
    RC_ASSERT(two.interval_clocks <= one.interval_clocks + copy);
    faster += two.interval_clocks < one.interval_clocks ? 1 : 0;
    slower += two.interval_clocks > one.interval_clocks ? 1 : 0;
  }));
  CHECK((!testing::draws_usual_cases() || faster > slower));
}

TEST_CASE("rejects a Program that overwrites the memory of the previous picture") {
  Machine machine = with_buffers(machine_with({}), 2, ScanOutPort::own);
  machine.name = "mine";
  const auto check = [&](const Instruction& instruction, std::uint32_t colour_bits) {
    machine.kind->check(coloured(make_program({{.opcode = Opcode::enable_all}, instruction}), colour_bits), machine);
  };
  CHECK_NOTHROW(check({.opcode = Opcode::set_constant, .fields = {{{20, 12}}}}, 8));
  CHECK_THROWS_WITH_AS(
      check({.opcode = Opcode::set_constant, .fields = {{{20, 13}}}}, 8),
      "segment 0, instruction 1: set_constant overlaps the 8 bits from bit 32 on, from which mine displays a "
      "picture while it draws the next; compile the model for this machine, or use a machine with "
      "scan_out.buffers = 1",
      InputError);
  CHECK_THROWS_WITH_AS(check({.opcode = Opcode::enable_all}, 21),
                       doctest::Contains("the colour field overlaps the 21 bits from bit 19 on"), InputError);
  machine = with_buffers(machine, 1, ScanOutPort::own);
  CHECK_NOTHROW(check({.opcode = Opcode::set_constant, .fields = {{{20, 13}}}}, 21));
}