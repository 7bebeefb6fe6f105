#include "host/facet/planes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

namespace csgsim::facet {

namespace {

/// Components this near to 0 do not decide a canonical orientation.
constexpr double zero_component = 4.0 * coincidence_tolerance;

/// Of the grid: wide against the tolerance, so that what is near a plane is seldom in another cell than the plane. A
/// power of two, and cells are centred on its multiples: components such as 0, 1/2 and 1 are far from their sides.
constexpr double cells_per_unit = 0x1p31;

constexpr std::uint32_t free_slot = 0xffffffffU;
constexpr std::size_t fewest_slots = 64;

bool points_backward(const glm::dvec3& normal) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(normal[axis]) > zero_component) return normal[axis] < 0.0;
  }
  return false;
}

using Key = std::array<double, 4>;
using Cell = std::array<double, 4>;

Key key_of(const Plane& plane, double diagonal) {
  return {plane.normal.x, plane.normal.y, plane.normal.z, plane.offset / diagonal};
}

double cell_at(double component) { return std::floor(component * cells_per_unit + 0.5); }

std::uint64_t hash(const Cell& cell) {
  std::uint64_t sum = 0;
  for (const double one : cell) {
    // Past 2^53 cells are as wide as doubles are apart, and their numbers only have to differ.
    sum = (sum ^ std::bit_cast<std::uint64_t>(one + 0.0)) * 0x9e3779b97f4a7c15U;
    sum ^= sum >> 32U;
  }
  return sum;
}

bool are_near(const Key& one, const Key& other) {
  for (std::size_t i = 0; i < one.size(); ++i) {
    const bool is_near = other[i] >= one[i] - coincidence_tolerance && other[i] <= one[i] + coincidence_tolerance;
    if (!is_near) return false;
  }
  return true;
}

/// Calls visit(cell) for each cell that what is near the key may be in.
template <class Visit>
void for_cells_near(const Key& key, const Visit& visit) {
  Cell low;
  Cell high;
  for (std::size_t i = 0; i < key.size(); ++i) {
    low[i] = cell_at(key[i] - coincidence_tolerance);
    high[i] = cell_at(key[i] + coincidence_tolerance);
  }
  for (unsigned corner = 0; corner < 1U << key.size(); ++corner) {
    Cell cell = low;
    bool is_other = true;
    for (std::size_t i = 0; i < key.size(); ++i) {
      if ((corner >> i & 1U) == 0) continue;
      is_other = is_other && high[i] != low[i];
      cell[i] = high[i];
    }
    if (is_other) visit(cell);
  }
}

}  // namespace

PlaneTable::PlaneTable(const glm::dvec3& centre, double diagonal)
    : centre_(centre), diagonal_(diagonal > 0.0 ? diagonal : 1.0), slots_(fewest_slots, free_slot) {}

/// The first of the planes that coincide with that one.
std::optional<std::uint32_t> PlaneTable::find(const Plane& canonical) const {
  const Key key = key_of(canonical, diagonal_);
  const std::size_t last = slots_.size() - 1;
  std::uint32_t first = free_slot;
  for_cells_near(key, [&](const Cell& cell) {
    for (std::size_t at = hash(cell) & last; slots_[at] != free_slot; at = (at + 1) & last) {
      if (are_near(key, key_of(planes_[slots_[at]], diagonal_))) first = std::min(first, slots_[at]);
    }
  });
  if (first == free_slot) return std::nullopt;
  return first;
}

void PlaneTable::enter(std::uint32_t plane) {
  const Key key = key_of(planes_[plane], diagonal_);
  Cell cell;
  std::transform(key.begin(), key.end(), cell.begin(), cell_at);
  const std::size_t last = slots_.size() - 1;
  std::size_t at = hash(cell) & last;
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
