#include "hw/pixel_square/timing_division.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "hw/base/error.h"
#include "hw/base/quotient.h"
#include "hw/division/model_sizes.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/operands.h"
#include "hw/pixel_square/figures.h"
#include "hw/pixel_square/storage_check.h"

namespace csgsim::pixel_square {

namespace {

const Figures& figures_of(const machines::Machine& machine) { return machines::kind_figures<Figures>(machine); }

std::uint64_t beyond(std::uint64_t needed, std::uint64_t available) { return needed - std::min(needed, available); }

}  // namespace

DivisionClocks::DivisionClocks(const isa::Program& program, const machines::Machine& machine) : machine_(machine) {
  const division::ModelSizes sizes = division::read_model_sizes(program.display_model);
  const std::uint64_t port = figures_of(machine).record_bits;
  const std::uint64_t plane_bits = 1 + 2 * std::uint64_t{sizes.slope} + sizes.constant;
  const bool is_remote = has_remote_planes(program.display_model.size(), sizes.planes, plane_bits, figures_of(machine));
  const std::uint64_t plane =
      is_remote ? machine.link.latency + quotient_up(plane_bits, machine.link.width) * machine.link.word_clocks
                : quotient_up(plane_bits, port);
  nodes_ = sizes.nodes;
  primitive_ = quotient_up(64 + 2 * std::uint64_t{sizes.depth} + sizes.colour + sizes.halfspaces, port);
  halfspace_ = quotient_up(std::uint64_t{sizes.plane} + 1 + sizes.colour, port) + plane;
}

std::uint64_t DivisionClocks::tree_clocks() const { return nodes_ * figures_of(machine_).node_clocks; }

/// Reading and testing overlap: each half-space takes the longer of both times, and each list additionally the shorter
/// time once.
std::uint64_t DivisionClocks::list_clocks(std::uint64_t lists, std::uint64_t halfspaces, std::uint64_t read) const {
  const std::uint64_t test = figures_of(machine_).halfspace_clocks;
  return halfspaces * std::max(read, test) + lists * std::min(read, test);
}

std::uint64_t DivisionClocks::group_clocks(const isa::DivisionCounts& group_counts) const {
  const Figures& figures = figures_of(machine_);
  const std::uint64_t again = std::max(halfspace_, std::uint64_t{figures.halfspace_clocks});
  return group_counts.group_boxes * (primitive_ + figures.box_clocks) +
         list_clocks(group_counts.group_lists, group_counts.group_halfspaces, halfspace_) +
         group_counts.group_cells * (figures.cell_clocks + again) +
         std::min<std::uint64_t>(group_counts.group_entries, figures.list_entries);
}

std::uint64_t DivisionClocks::test_clocks(const isa::DivisionStep& step, bool from_list) const {
  const Figures& figures = figures_of(machine_);
  const std::uint64_t number = from_list ? 1 : 0;
  const std::uint64_t spilt = beyond(step.halfspaces, figures.halfspaces);
  const std::uint64_t cell = figures.cell_clocks + (spilt > 0 ? spilt_halfspace_clocks(figures) : 0);
  return step.boxes * (primitive_ + number + figures.box_clocks) +
         list_clocks(step.lists, step.halfspaces, halfspace_ + number) + spilt * spilt_halfspace_clocks(figures) +
         step.cells * cell + step.nodes * figures.node_clocks +
         beyond(step.nodes, figures.nodes) * spilt_node_clocks(figures);
}

std::uint64_t DivisionClocks::instruction_clocks(const isa::Instruction& instruction) const {
  const bool is_linear = isa::has_operand(isa::operands_of(instruction.opcode), isa::OperandKind::linear);
  return is_linear ? figures_of(machine_).linear_clocks : 0;
}

bool DivisionClocks::is_listed(std::uint64_t survivor_count) const {
  return figures_of(machine_).levels == 2 && survivor_count <= figures_of(machine_).list_entries;
}

std::vector<std::size_t> divider_of_each_square(const isa::Program& program, const machines::Machine& machine) {
  const Figures& figures = figures_of(machine);
  const std::uint32_t side = figures.levels == 2 ? figures.group_side : 1;
  const std::uint64_t width = std::uint64_t{side} * machine.array.width;
  const std::uint64_t height = std::uint64_t{side} * machine.array.height;
  std::vector<std::size_t> dividers;
  std::optional<std::array<std::uint64_t, 2>> group;
  std::size_t turn = 0;
  for (const isa::Segment& segment : program.segments) {
    const std::array<std::uint64_t, 2> own{segment.region.x / width, segment.region.y / height};
    if (group && *group != own) ++turn;
    group = own;
    dividers.push_back(turn % figures.dividers);
  }
  return dividers;
}

void check_countable(const isa::Program& program, const machines::Machine& machine) {
  constexpr std::uint64_t max_tests = std::uint64_t{1} << 36U;
  constexpr std::uint64_t max_clocks = std::uint64_t{1} << 60U;
  const DivisionClocks clocks(program, machine);
  const auto reject = [&] {
    throw InputError(
        fmt::format("the divider would test for more than {} clocks; use a smaller model, or reduce the clocks "
                    "per test of {}",
                    max_clocks, machine.name));
  };
  const auto require_countable = [&](std::initializer_list<std::uint64_t> counts) {
    if (std::ranges::any_of(counts, [](std::uint64_t count) { return count > max_tests; })) reject();
  };
  double all = static_cast<double>(clocks.tree_clocks());
  for (const isa::Segment& segment : program.segments) {
    const isa::DivisionCounts& own = *segment.division;
    require_countable({own.group_boxes, own.group_lists, own.group_halfspaces, own.group_cells});
    all += static_cast<double>(clocks.group_clocks(own));
    for (const isa::DivisionStep& step : own.steps) {
      require_countable({step.boxes, step.lists, step.halfspaces, step.cells, step.nodes});
      all += static_cast<double>(clocks.test_clocks(step, true));
    }
    if (all > static_cast<double>(max_clocks)) reject();
  }
}

}  // namespace csgsim::pixel_square
