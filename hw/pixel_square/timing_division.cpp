#include "hw/pixel_square/timing_division.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "hw/base/error.h"

namespace csgsim::pixel_square {

namespace {

/// Tests of one sort.
struct Tests {
  std::uint64_t count = 0;
  std::uint64_t clocks = 0;  ///< each
};

auto tests_of(const isa::DivisionFacts& facts, const Figures& figures) {
  return std::to_array<Tests>({{facts.boxes, figures.box_clocks},
                               {facts.group_boxes, figures.box_clocks},
                               {facts.halfspaces, figures.halfspace_clocks},
                               {facts.group_halfspaces, figures.halfspace_clocks},
                               {facts.cells, figures.cell_clocks},
                               {facts.group_cells, figures.cell_clocks},
                               {facts.nodes, figures.node_clocks}});
}

}  // namespace

std::uint64_t test_clocks(const isa::DivisionFacts& facts, const Figures& figures) {
  if (figures.divider == DividerKind::host) return 0;
  std::uint64_t clocks = 0;
  for (const Tests& tests : tests_of(facts, figures)) clocks += tests.count * tests.clocks;
  return clocks;
}

void check_countable(const isa::Program& program, const machines::Machine& machine) {
  constexpr std::uint64_t most_tests = std::uint64_t{1} << 36U;
  constexpr std::uint64_t most_clocks = std::uint64_t{1} << 60U;
  std::uint64_t clocks = 0;
  for (const isa::Segment& segment : program.segments) {
    for (const Tests& tests : tests_of(segment.facts.division, machines::own<Figures>(machine))) {
      clocks += std::min(tests.count, most_tests) * tests.clocks;
      if (tests.count <= most_tests && clocks <= most_clocks) continue;
      throw InputError(
          fmt::format("the divider would test for more than {} clocks; give it a smaller model, or {} "
                      "fewer clocks a test",
                      most_clocks, machine.name));
    }
  }
}

}  // namespace csgsim::pixel_square
