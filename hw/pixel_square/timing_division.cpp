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

auto tests_of(const isa::DivisionCounts& counts, const Figures& figures) {
  return std::to_array<Tests>({{counts.boxes, figures.box_clocks},
                               {counts.group_boxes, figures.box_clocks},
                               {counts.halfspaces, figures.halfspace_clocks},
                               {counts.group_halfspaces, figures.halfspace_clocks},
                               {counts.cells, figures.cell_clocks},
                               {counts.group_cells, figures.cell_clocks},
                               {counts.nodes, figures.node_clocks}});
}

}  // namespace

std::uint64_t test_clocks(const isa::DivisionCounts& counts, const Figures& figures) {
  if (figures.divider == DividerKind::host) return 0;
  std::uint64_t clocks = 0;
  for (const Tests& tests : tests_of(counts, figures)) clocks += tests.count * tests.clocks;
  return clocks;
}

void check_countable(const isa::Program& program, const machines::Machine& machine) {
  constexpr std::uint64_t most_tests = std::uint64_t{1} << 36U;
  constexpr std::uint64_t most_clocks = std::uint64_t{1} << 60U;
  std::uint64_t clocks = 0;
  for (const isa::Segment& segment : program.segments) {
    for (const Tests& tests : tests_of(segment.division, machines::own<Figures>(machine))) {
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
