#include "host/facet/planes.h"

#include <algorithm>
#include <cstddef>
#include <glm/geometric.hpp>

namespace csgsim::facet {

namespace {

constexpr std::uint32_t free_slot = 0xffffffffU;
constexpr std::size_t min_slots = 64;

Key<4> make_key(const Plane& plane, double diagonal) {
  return {plane.normal.x, plane.normal.y, plane.normal.z, plane.offset / diagonal};
}

}  // namespace

PlaneTable::PlaneTable(const glm::dvec3& centre, double diagonal)
    : centre_(centre), diagonal_(diagonal > 0.0 ? diagonal : 1.0), slots_(min_slots, free_slot) {}

/// The first plane that coincides with the given one.
std::optional<std::uint32_t> PlaneTable::find(const Plane& canonical) const {
  const Key<4> key = make_key(canonical, diagonal_);
  const std::size_t last = slots_.size() - 1;
  std::uint32_t first = free_slot;
  for_each_near_cell(key, [&](const Key<4>& cell) {
    for (std::size_t at = hash_of(cell) & last; slots_[at] != free_slot; at = (at + 1) & last) {
      if (are_near(key, make_key(planes_[slots_[at]], diagonal_))) first = std::min(first, slots_[at]);
    }
  });
  if (first == free_slot) return std::nullopt;
  return first;
}

void PlaneTable::enter(std::uint32_t plane) {
  const Key<4> key = make_key(planes_[plane], diagonal_);
  const std::size_t last = slots_.size() - 1;
  std::size_t at = hash_of(cell_of(key)) & last;
  while (slots_[at] != free_slot) at = (at + 1) & last;
  slots_[at] = plane;
}

Halfspace PlaneTable::add(const Plane& plane) {
  Plane canonical{plane.normal, plane.offset + glm::dot(plane.normal, centre_)};
  const bool positive = !points_backward(canonical.normal);
  if (!positive) canonical = {-canonical.normal, -canonical.offset};
  if (const std::optional<std::uint32_t> found = find(canonical)) return {*found, positive};
  const auto added = static_cast<std::uint32_t>(planes_.size());
  planes_.push_back(canonical);
  if (2 * planes_.size() > slots_.size()) {
    slots_.assign(2 * slots_.size(), free_slot);
    for (std::uint32_t i = 0; i <= added; ++i) enter(i);
  } else {
    enter(added);
  }
  return {added, positive};
}

}  // namespace csgsim::facet
