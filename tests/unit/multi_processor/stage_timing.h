#pragma once

#include <rapidcheck.h>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "hw/division/encoding.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/machines/regions.h"
#include "hw/multi_processor/figures.h"
#include "hw/multi_processor/kind.h"
#include "hw/multi_processor/timing.h"
#include "tests/support/random_program.h"

/// Multi-processors and Programs with hand-counted clocks.
namespace csgsim::testing::stages {

using isa::Opcode;
using machines::Machine;
using multi_processor::Figures;
using multi_processor::FrameAccount;
using multi_processor::NodeActivity;
using multi_processor::NodeClocks;
using multi_processor::RenderingOrder;

/// A machine of 2 x 2 nodes and a segment of 4 x 4 pixels; its clock figures are distinguishable in a sum.
inline Machine machine_4x4() {
  Machine machine = machines::blank_machine(multi_processor::kind);
  machine.name = "four";
  machine.array = {2, 2, 16};
  machine.picture = {4, 4};
  machine.clock_hz = 8'000'000;
  machine.link = {.width = 32, .word_clocks = 10, .fifo_depth = 1, .latency = 4};
  machine.own = Figures{
      .levels = 0,
      .order = RenderingOrder::segment,
      .word_bits = 16,
      .memory_words = 1000,
      .operations =
          {.read = 2, .write = 3, .add = 5, .compare = 7, .logic = 11, .multiply = 13, .shift = 67, .shift_bit = 71},
      .loop = {.pixel = 17, .row = 19, .instruction = 23},
      .node_tests = {.primitive = 29, .halfspace = 31, .cell = 47, .tree_node = 53, .instruction = 59},
      .display_tests = {.primitive = 37, .halfspace = 41, .cell = 61},
      .host = {.width = 16, .word_clocks = 3, .latency = 5},
      .display_memory_words = 1000,
      .transform_clocks = 43,
      .divides_ahead = false,
      .barrier_clocks = 6};
  return machine;
}

inline Figures& figures(Machine& machine) { return machines::kind_figures<Figures>(machine); }

/// Returns a model of two primitives with five half-spaces on three planes: 264 bits of header, 3 planes of 8, 2
/// primitives of 77, 5 half-spaces of 3 bits, 3 of them with a colour of 3 bits, and nodes of 1, 1 and 4 bits: 59
/// bytes.
inline std::vector<std::uint8_t> model_bytes() {
  division::DisplayModel model;
  model.width = 4;
  model.height = 4;
  model.z_bits = 4;
  model.colour_bits = 3;
  model.fields = {.depth = {0, 4}, .candidate = {4, 4}, .colour = {8, 3}, .candidate_colour = {}, .mask = {11, 1}};
  model.planes = {{false, 1, 0, 3}, {false, 0, 1, 3}, {false, 1, 1, 3}};
  const division::Box box{{0, 0, 3, 3}, 0, 15};
  model.primitives = {{{box, false, false, 1}, {{0, true, 1}, {1, true, 2}, {2, false, 0}}},
                      {{box, false, false, 1}, {{0, true, 3}, {1, false, 0}}}};
  model.nodes = {{}, {}, {2, division::Operator::unite}};
  const division::Bits bits = division::encode(model);
  std::vector<std::uint8_t> bytes((bits.count + 7) / 8);
  for (std::size_t i = 0; i < bytes.size(); ++i)
    bytes[i] = static_cast<std::uint8_t>(bits.words[i / 8] >> (i % 8 * 8) & 0xffU);
  return bytes;
}

/// Returns a Program with one primitive of three half-spaces left in the segment; its first subsegment has two
/// instructions.
inline isa::Program program_for(const Machine& machine) {
  isa::Program program;
  program.shape = {machine.picture.width, machine.picture.height, 16};
  program.colour = {0, 8};
  program.display_model = model_bytes();
  for (const isa::Region& region : machines::regions(machine)) program.segments.push_back({region, {}});
  isa::Segment& first = program.segments.front();
  first.instructions.push_back({.opcode = Opcode::enable_all});
  first.instructions.push_back(
      {.opcode = Opcode::load_linear, .fields = {isa::Field{0, 8}}, .linear = {1, 2, 3, 20, 4}});
  for (isa::Segment& segment : program.segments) segment.division->steps = {{.boxes = 1}};
  *first.division = {.steps = {{.boxes = 1, .halfspaces = 3, .cells = 1, .nodes = 2, .instructions = 2}},
                     .group_boxes = 2,
                     .group_halfspaces = 3,
                     .group_cells = 2,
                     .group_entries = 1 + 3};
  return program;
}

inline FrameAccount account_of(const isa::Program& program, const Machine& machine) {
  return multi_processor::time_stages(program, machine).account;
}

inline std::uint64_t clocks_of(const isa::Program& program, const Machine& machine) {
  return multi_processor::time_stages(program, machine).clocks;
}

inline std::uint64_t spent(const FrameAccount& account, NodeActivity activity) {
  return std::accumulate(account.nodes.begin(), account.nodes.end(), std::uint64_t{0},
                         [activity](std::uint64_t sum, const NodeClocks& node) { return sum + node.of(activity); });
}

inline Machine random_machine() {
  const auto below = [](std::uint32_t most) { return *rc::gen::inRange<std::uint32_t>(0, most); };
  Machine machine = machine_4x4();
  machine.array = {1 + below(4), 1 + below(4), 40};
  machine.picture = {1 + below(24), 1 + below(24)};
  machine.link = {.width = 1 + below(70), .word_clocks = 1 + below(9), .fifo_depth = 1, .latency = below(20)};
  figures(machine).memory_words = 1U << 30U;
  figures(machine).levels = below(5);
  figures(machine).order = static_cast<RenderingOrder>(below(3));
  figures(machine).word_bits = 1 + below(64);
  figures(machine).display_tests = {below(60), below(600)};
  figures(machine).display_memory_words = 1U << 30U;
  figures(machine).host = {1 + below(70), 1 + below(9), below(20)};
  figures(machine).barrier_clocks = below(50);
  return machine;
}

/// Returns a Program with arbitrary instructions and counts, which need not result from any division.
inline isa::Program any_program(const Machine& machine) {
  const auto below = [](std::uint32_t most) { return *rc::gen::inRange<std::uint32_t>(0, most); };
  isa::Program program = *test::arbitrary_program_in_parts(machine, 8);
  program.display_model = model_bytes();
  for (isa::Segment& segment : program.segments)
    *segment.division = {.steps = {{.boxes = below(3),
                                    .halfspaces = below(20),
                                    .cells = below(20),
                                    .nodes = below(5),
                                    .instructions = segment.instructions.size()}},
                         .group_boxes = below(3),
                         .group_halfspaces = below(9),
                         .group_cells = below(30)};
  return program;
}

}  // namespace csgsim::testing::stages
