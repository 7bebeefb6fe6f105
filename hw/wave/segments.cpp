#include "hw/wave/segments.h"

#include <fmt/format.h>

#include <algorithm>

#include "hw/base/error.h"

namespace csgsim::wave {

std::uint32_t segment_of(Pixel pixel, const isa::Program& program) {
  const auto found = std::ranges::find_if(
      program.segments, [&](const isa::Segment& segment) { return segment.region.holds(pixel.x, pixel.y); });
  if (found == program.segments.end())
    throw InputError(
        fmt::format("no segment of the Program contains pixel {},{}; choose another --pixel", pixel.x, pixel.y));
  return static_cast<std::uint32_t>(found - program.segments.begin());
}

std::string corner_text(const isa::Segment& segment) {
  return fmt::format("{},{}", segment.region.x, segment.region.y);
}

void check_no_tree_levels(const Request& request) {
  if (request.tree_levels.empty()) return;
  throw InputError("this machine has no multiplier trees; remove the tree levels, or use another --machine");
}

}  // namespace csgsim::wave
