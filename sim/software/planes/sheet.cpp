#include "sim/software/planes/sheet.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace csgsim::software {

void Sheet::clear() {
  points_.clear();
  places_.clear();
  exactly_.clear();
}

std::uint32_t Sheet::add_meeting(std::uint32_t one, std::uint32_t other) {
  points_.push_back(planes_.meet(plane_, one, other));
  places_.push_back(place_of(points_.back()));
  exactly_.emplace_back();
  return static_cast<std::uint32_t>(points_.size() - 1);
}

Region Sheet::begin(std::uint32_t plane) {
  plane_ = plane;
  clear();
  const std::array<double, 4>& normal = planes_.coefficients(plane);
  int axis = 0;
  for (int other = 1; other < 3; ++other) {
    if (std::abs(normal[static_cast<std::size_t>(other)]) > std::abs(normal[static_cast<std::size_t>(axis)]))
      axis = other;
  }
  // Counter-clockwise as seen along the axis, if the normal has the same direction.
  int across = (axis + 1) % 3;
  int up = (axis + 2) % 3;
  if (normal[static_cast<std::size_t>(axis)] < 0) std::swap(across, up);
  const std::uint32_t last = WholePlanes::walls - 1;
  const std::array<std::uint32_t, 4> walls{planes_.wall(up, 0), planes_.wall(across, last), planes_.wall(up, last),
                                           planes_.wall(across, 0)};
  Region region;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    region.corners.push_back(add_meeting(walls[(i + 3) % 4], walls[i]));
    region.planes.push_back(walls[i]);
  }
  return region;
}

Region Sheet::begin(std::uint32_t plane, std::span<const std::uint32_t> sides) {
  plane_ = plane;
  clear();
  Region region;
  std::uint32_t before = sides.back();
  for (const std::uint32_t along : sides) {
    region.corners.push_back(add_meeting(before, along));
    region.planes.push_back(along);
    before = along;
  }
  return region;
}

Bounds Sheet::bounds(const Region& region) const {
  Bounds bounds;
  UnitBox& box = bounds.box;
  box = {places_[region.corners[0]], places_[region.corners[0]]};
  for (const std::uint32_t corner : region.corners) {
    box.low = glm::min(box.low, places_[corner]);
    box.high = glm::max(box.high, places_[corner]);
  }
  bounds.middle = (box.low + box.high) / 2.0;
  double error = 0;
  for (const std::uint32_t corner : region.corners) {
    bounds.radius = std::max(bounds.radius, glm::distance(bounds.middle, places_[corner]));
    error = std::max(error, deviation(corner));
  }
  bounds.radius += error;
  box.low -= error;
  box.high += error;
  return bounds;
}

Sheet::Sides Sheet::sides(const Region& region, facet::Halfspace halfspace) const {
  Sides sides;
  for (const std::uint32_t corner : region.corners) {
    const int here = side(corner, halfspace.plane);
    if (here == 0) continue;
    ((here < 0) == halfspace.positive ? sides.any_in : sides.any_out) = true;
    if (sides.any_in && sides.any_out) break;
  }
  return sides;
}

std::optional<Chord> Sheet::chord(const Region& region, std::uint32_t plane) const {
  const Sides reached = sides(region, {plane, true});
  if (!reached.any_in || !reached.any_out) return std::nullopt;
  Chord chord;
  std::size_t ends = 0;
  const std::size_t count = region.corners.size();
  for (std::size_t i = 0; i < count && ends < chord.ends.size(); ++i) {
    const Meeting& corner = points_[region.corners[i]];
    const int here = side(region.corners[i], plane);
    const int next = side(region.corners[(i + 1) % count], plane);
    if (here != 0 && here * next >= 0) continue;
    // The next side leaves the plane, because corners lie on both sides of it.
    chord.ends[ends] = here == 0 ? corner : planes_.meet(plane_, plane, region.planes[i]);
    chord.sides[ends] = region.planes[i];
    ++ends;
  }
  return ends == chord.ends.size() ? std::optional(chord) : std::nullopt;
}

bool overlap(const WholePlanes& planes, const Chord& one, const Chord& other) {
  for (std::size_t i = 0; i < other.sides.size(); ++i) {
    const int in = planes.side(other.ends[1 - i], other.sides[i]);
    const auto is_beyond = [&](const Meeting& end) { return planes.side(end, other.sides[i]) * in <= 0; };
    if (is_beyond(one.ends[0]) && is_beyond(one.ends[1])) return false;
  }
  return true;
}

void Sheet::find_sides(const Region& region, facet::Halfspace halfspace) {
  sides_.clear();
  for (const std::uint32_t corner : region.corners) {
    const int here = side(corner, halfspace.plane);
    sides_.push_back(halfspace.positive ? here : -here);
  }
}

/// Walks around a region whose corners are classified, and passes on corners with the planes of the following sides.
template <class In, class Out>
void Sheet::trace(const Region& region, std::uint32_t plane, const In& to_in, const Out& to_out) {
  const std::size_t count = region.corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const int here = sides_[i];
    const int next = sides_[(i + 1) % count];
    const std::uint32_t corner = region.corners[i];
    const std::uint32_t along = region.planes[i];
    if (here <= 0) to_in(corner, here == 0 && next > 0 ? plane : along);
    if (here >= 0) to_out(corner, here == 0 && next < 0 ? plane : along);
    if (here * next >= 0) continue;
    const std::uint32_t crossing = add_meeting(along, plane);
    to_in(crossing, here < 0 ? plane : along);
    to_out(crossing, here > 0 ? plane : along);
  }
}

Parts Sheet::cut(const Region& region, facet::Halfspace halfspace) {
  find_sides(region, halfspace);
  Parts parts;
  if (std::ranges::find(sides_, 1) == sides_.end()) {
    parts.in = region;
    return parts;
  }
  if (std::ranges::find(sides_, -1) == sides_.end()) {
    parts.out = region;
    return parts;
  }
  const auto add_to = [](Region& part) {
    return [&part](std::uint32_t corner, std::uint32_t along) {
      part.corners.push_back(corner);
      part.planes.push_back(along);
    };
  };
  trace(region, halfspace.plane, add_to(parts.in), add_to(parts.out));
  return parts;
}

Region Sheet::clip(const Region& region, facet::Halfspace halfspace) { return cut(region, halfspace).in; }

}  // namespace csgsim::software
