#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <vector>

#include "hw/isa/opcodes.h"
#include "hw/isa/wire.h"
#include "hw/machines/clocks.h"
#include "hw/machines/link_timing.h"
#include "hw/machines/timing.h"
#include "hw/pixel_planes/figures.h"
#include "hw/pixel_planes/kind.h"
#include "hw/pixel_planes/timing.h"
#include "tests/support/random_program.h"

using namespace csgsim;
using isa::Instruction;
using isa::Opcode;
using machines::Machine;

namespace {

constexpr isa::ArrayShape shape{8, 8, 40};
constexpr std::uint64_t tree_latency = 6;

Machine machine_with(const machines::Link& link, std::uint32_t clear_clocks = 0, std::uint32_t fan_in = 0) {
  Machine machine = machines::blank(pixel_planes::kind);
  machine.array = shape;
  machine.link = link;
  machine.clear_clocks = clear_clocks;
  machines::own<pixel_planes::Figures>(machine).or_fan_in = fan_in;
  return machine;
}

isa::Program program_of(std::vector<Instruction> instructions) {
  isa::Program program;
  program.shape = shape;
  program.segments = {{.region = {0, 0, 8, 8}, .instructions = std::move(instructions)}};
  return program;
}

std::uint64_t clocks_of(const machines::FrameTiming& timing, std::size_t part, std::string_view activity) {
  const auto& clocks = timing.account.parts[part].clocks;
  return std::find_if(clocks.begin(), clocks.end(), [&](const auto& one) { return one.activity == activity; })->clocks;
}

/// Some of the questions of a Program are answered by a jump; which, is drawn by lot.
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

/// Random figures of a link, and figures of which each is as good or better.
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

/// What the parts have to do for what is carried out, each for itself.
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

TEST_CASE("an OR of so many lines has a level for each power of its fan-in") {
  CHECK(pixel_planes::or_levels(512 * 512, 64) == 3);
  CHECK(pixel_planes::or_levels(64, 64) == 1);
  CHECK(pixel_planes::or_levels(65, 64) == 2);
  CHECK(pixel_planes::or_levels(1, 64) == 0);
  CHECK(pixel_planes::or_levels(512 * 512, 2) == 18);
  CHECK(pixel_planes::or_levels(512 * 512, 0) == 0);
}

// By hand, edges from the request at 0: the host knows of it at 1; SegmentStart's 70 bits are three words of 32, stored
// at 6, 7, 8 after a latency of 4, read at 7, 8, 9; clearing begins at 10 and takes 3 clocks. enable_all's word is
// stored at 9, read at 10, the edge that empties the register, and begins at 13; FrameEnd's is stored at 10, read at
// 13, and begins at 14, and the step is carried out 6 clocks later.
TEST_CASE("a small frame takes the clocks counted by hand") {
  const machines::FrameTiming timing =
      machines::time_frame(program_of({{.opcode = Opcode::enable_all}}),
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

// As above until edge 13, where the question begins: 1 clock, 6 of the trees and 2 levels of the OR; the answer is
// there at 22, the host knows of it at 23, sends FrameEnd from 27 on, stores it at 28; it is read at 29 and begins
// at 30.
TEST_CASE("a jump takes the clocks counted by hand, and what was sent in vain is counted") {
  const Machine machine = machine_with({.width = 32, .word_clocks = 1, .fifo_depth = 2, .latency = 4}, 3, 8);
  const std::vector<machines::Skip> skips{{0, 0}};
  isa::Program program = program_of({{.opcode = Opcode::skip_if_none, .constant = 3},
                                     {.opcode = Opcode::enable_all},
                                     {.opcode = Opcode::enable_all},
                                     {.opcode = Opcode::enable_all}});
  const machines::FrameTiming timing = machines::time_frame(program, machine, skips);
  // The question is 38 bits, two words, stored at 9 and 10, read at 10 and 11; it begins at 13, its bits are gone.
  CHECK(timing.clocks == 36);
  CHECK(clocks_of(timing, 0, "answering") == 8);
  CHECK(clocks_of(timing, 0, "jumping") == 8);
  CHECK(clocks_of(timing, 0, "starved") == 10);
  // Three and two, one in the register, two in the FIFO, FrameEnd.
  CHECK(timing.account.count("link_words") == 3 + 2 + 1 + 2 + 1);
}

TEST_CASE("no frame is shorter than the work of its busiest part, none longer than all of it one after the other") {
  rc::check("a frame lies between what its parts have to do side by side and one after the other", [] {
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
  });
}

TEST_CASE("a better link never costs a clock") {
  rc::check("a link that is wider, faster, deeper or sooner there costs no clock", [] {
    const auto program = *test::arbitrary_program(shape, 30);
    const auto skips = arbitrary_skips(program);
    const Links links = arbitrary_links();
    const std::uint32_t clear_clocks = *rc::gen::inRange(0U, 50U);
    const auto clocks = [&](const machines::Link& link) {
      return machines::time_frame(program, machine_with(link, clear_clocks, 8), skips).clocks;
    };
    RC_ASSERT(clocks(links.better) <= clocks(links.worse));
  });
}
