#include "sim/software/display/faults.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace csgsim::software {

namespace {

/// Maximum depth difference of coincident surfaces in steps; exceeds the rounding errors of doubles.
constexpr double coincidence = 0x1p-10;

struct Surface {
  Event event;
  double depth;
};

/// Cause of the fault of a surface that ties with others, or was drawn before surfaces with smaller integer depths.
Fault fault_near(const WrongRay& ray, const Surface& surface) {
  const auto coinciding =
      std::ranges::count_if(ray.depths, [&](double other) { return std::abs(other - surface.depth) <= coincidence; });
  if (coinciding < 2) return Fault::depth_bits;
  const std::uint32_t depth = surface.event.depth;
  const auto near = std::ranges::count_if(
      ray.events, [&](const Event& other) { return std::max(other.depth, depth) - std::min(other.depth, depth) <= 1; });
  return near <= 2 ? Fault::coincident : Fault::three_way;
}

}  // namespace

void Faults::add(Fault fault) {
  switch (fault) {
    case Fault::depth_bits: ++depth_bits; break;
    case Fault::coincident: ++coincident; break;
    case Fault::three_way: ++three_way; break;
    case Fault::order: ++order; break;
  }
}

Fault fault_of(const WrongRay& ray, std::span<const Event> drawn) {
  std::vector<Surface> left;
  for (std::size_t i = 0; i < ray.events.size(); ++i) left.push_back({ray.events[i], ray.depths[i]});
  std::optional<Fault> worst;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const auto place =
        std::ranges::find(left, drawn[i].crossing, [](const Surface& one) { return one.event.crossing; });
    if (place == left.end()) return Fault::order;
    const bool is_tied = i + 1 == drawn.size() && std::ranges::count(ray.events, place->event.depth, &Event::depth) > 1;
    for (auto overtaken = left.begin(); overtaken != place; ++overtaken) {
      if (place->depth - overtaken->depth > ray.rounding) return Fault::order;
    }
    if (place != left.begin() || is_tied) worst = std::max(worst.value_or(Fault::depth_bits), fault_near(ray, *place));
    left.erase(place);
  }
  return worst.value_or(ray.has_lost ? Fault::depth_bits : Fault::order);
}

}  // namespace csgsim::software
