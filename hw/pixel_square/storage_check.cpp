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

std::uint64_t beyond(std::uint64_t needed, std::uint64_t there) { return needed > there ? needed - there : 0; }

/// Bits of what the memories for a surface at hand do not hold.
std::uint64_t spilt_bits(const isa::DivisionStep& surface, const Figures& figures) {
  constexpr std::uint64_t most = std::uint64_t{1} << 40U;
  return std::min(beyond(surface.halfspaces, figures.halfspaces), most) * halfspace_entry_bits(figures) +
         std::min(beyond(surface.nodes, figures.nodes), most) * node_entry_bits;
}

/// The groups that the machine's dividers make; none for one level.
std::vector<division::Group> groups_of(const isa::Program& program, const machines::Machine& machine) {
  const Figures& figures = machines::own<Figures>(machine);
  if (figures.levels < 2) return {};
  std::vector<isa::Region> regions;
  regions.reserve(program.segments.size());
  for (const isa::Segment& segment : program.segments) regions.push_back(segment.region);
  return division::groups_of(regions, program.shape, machine.array, figures.group_side, figures.group_side);
}

}  // namespace

bool has_far_planes(std::uint64_t model_bytes, std::uint64_t planes, std::uint64_t plane_bits, const Figures& figures) {
  return byte_bits * model_bytes > figures.model_bits && planes > 0 && plane_bits > 0;
}

void check_storage(const isa::Program& program, const machines::Machine& machine) {
  const Figures& figures = machines::own<Figures>(machine);
  const division::ModelSizes sizes = division::sizes_of(program.display_model);
  const std::uint64_t plane_bits = 1 + 2 * std::uint64_t{sizes.slope} + sizes.constant;
  std::uint64_t kept = byte_bits * program.display_model.size();
  if (has_far_planes(program.display_model.size(), sizes.planes, plane_bits, figures))
    kept -= std::min(kept, sizes.planes * plane_bits);
  if (kept > figures.model_bits) {
    throw InputError(
        fmt::format("the display model has {} bits besides its planes, and the divider's memory holds {}; give "
                    "divider.memory more, or the model fewer faces",
                    kept, figures.model_bits));
  }
  for (const isa::Segment& square : program.segments) {
    for (const isa::DivisionStep& surface : square.division->steps) {
      const std::uint64_t spilt = spilt_bits(surface, figures);
      if (spilt <= figures.model_bits - kept) continue;
      throw InputError(fmt::format(
          "the square at {},{} has {} half-spaces and {} nodes of the tree to look at for one surface: with "
          "the model's {} bits these are more than divider.halfspaces, divider.nodes and divider.memory "
          "hold; give them more, or the model fewer faces",
          square.region.x, square.region.y, surface.halfspaces, surface.nodes, kept));
    }
  }
}

void check_division(const isa::Program& program, const machines::Machine& machine) {
  const Figures& figures = machines::own<Figures>(machine);
  if (figures.divider != DividerKind::corners) return;
  division::check_division(program, groups_of(program, machine), figures.list_entries);
}

}  // namespace csgsim::pixel_square
