#include "hw/pixel_square/storage_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "hw/base/error.h"
#include "hw/division/division_check.h"
#include "hw/division/model_sizes.h"
#include "hw/isa/host_counts.h"

namespace csgsim::pixel_square {

namespace {

constexpr std::uint64_t byte_bits = 8;

std::uint64_t beyond(std::uint64_t needed, std::uint64_t available) {
  return needed > available ? needed - available : 0;
}

/// Bits that do not fit the half-space and node memories of the current surface.
std::uint64_t spilt_bits(const isa::DivisionStep& surface, const Figures& figures) {
  constexpr std::uint64_t max_overflow = std::uint64_t{1} << 40U;
  return std::min(beyond(surface.halfspaces, figures.halfspaces), max_overflow) * halfspace_entry_bits(figures) +
         std::min(beyond(surface.nodes, figures.nodes), max_overflow) * node_entry_bits;
}

/// Groups formed by the machine's dividers; empty if there is one level.
std::vector<division::Group> divider_groups(const isa::Program& program, const machines::Machine& machine) {
  const Figures& figures = machines::kind_figures<Figures>(machine);
  if (figures.levels < 2) return {};
  std::vector<isa::Region> regions;
  regions.reserve(program.segments.size());
  for (const isa::Segment& segment : program.segments) regions.push_back(segment.region);
  return division::group_squares(regions, program.shape, machine.array, figures.group_side, figures.group_side);
}

}  // namespace

bool has_remote_planes(std::uint64_t model_bytes, std::uint64_t plane_count, std::uint64_t plane_bits,
                       const Figures& figures) {
  return byte_bits * model_bytes > figures.model_bits && plane_count > 0 && plane_bits > 0;
}

void check_storage(const isa::Program& program, const machines::Machine& machine) {
  const Figures& figures = machines::kind_figures<Figures>(machine);
  const division::ModelSizes sizes = division::read_model_sizes(program.display_model);
  const std::uint64_t plane_bits = 1 + 2 * std::uint64_t{sizes.slope} + sizes.constant;
  std::uint64_t kept = byte_bits * program.display_model.size();
  if (has_remote_planes(program.display_model.size(), sizes.planes, plane_bits, figures))
    kept -= std::min(kept, sizes.planes * plane_bits);
  if (kept > figures.model_bits) {
    throw InputError(
        fmt::format("the display model has {} bits without its planes, but the divider's memory holds {}; increase "
                    "divider.memory, or use a model with fewer faces",
                    kept, figures.model_bits));
  }
  for (const isa::Segment& square : program.segments) {
    for (const isa::DivisionStep& surface : square.division->steps) {
      const std::uint64_t spilt = spilt_bits(surface, figures);
      if (spilt <= figures.model_bits - kept) continue;
      throw InputError(fmt::format(
          "the square at {},{} needs {} half-spaces and {} tree nodes for one surface; together with the model's {} "
          "bits these exceed divider.halfspaces, divider.nodes and divider.memory; increase them, or use a model with "
          "fewer faces",
          square.region.x, square.region.y, surface.halfspaces, surface.nodes, kept));
    }
  }
}

void check_division(const isa::Program& program, const machines::Machine& machine) {
  const Figures& figures = machines::kind_figures<Figures>(machine);
  if (figures.divider != DividerKind::corners) return;
  division::check_division(program, divider_groups(program, machine), figures.list_entries);
}

}  // namespace csgsim::pixel_square
