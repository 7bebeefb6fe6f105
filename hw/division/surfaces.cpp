#include "hw/division/surfaces.h"

#include <algorithm>

#include "hw/division/cells.h"

namespace csgsim::division {

namespace {

/// Narrows the box's depths to those that the corner values of fronts and backs permit. The box becomes empty if an
/// edge excludes all of it.
void narrow(Box& box, const std::vector<TestedHalfspace>& tested) {
  bool is_empty = false;
  for (const TestedHalfspace& one : tested) {
    switch (one.side) {
      case Side::front: box.z_low = std::max(box.z_low, one.low); break;
      case Side::back: box.z_high = std::min(box.z_high, one.high); break;
      case Side::not_negative:
      case Side::negative:
        is_empty = is_empty || classify_between(one, box.z_low, box.z_high) == Containment::out;
        break;
    }
  }
  if (is_empty) box.z_high = box.z_low - 1;
}

}  // namespace

Surface intersect_boxes(Datapath& path, const Candidates& candidates, std::uint32_t first, std::uint32_t count,
                        const Rectangle& square) {
  Surface surface{first, count, false, 0, {square, 0, path.header().farthest()}, {}};
  bool is_empty = false;
  for (std::uint32_t i = first; i < first + count; ++i) {
    if (!candidates.listed[i]) {
      is_empty = true;
      continue;
    }
    const PrimitiveHead primitive = path.visit_primitive(i);
    is_empty = is_empty || primitive.box.empty();
    surface.box.pixels = overlap(surface.box.pixels, primitive.box.pixels);
    surface.box.z_low = std::max(surface.box.z_low, primitive.box.z_low);
    surface.box.z_high = std::min(surface.box.z_high, primitive.box.z_high);
    if (i > first) continue;
    surface.complemented = primitive.complemented;
    surface.near_colour = primitive.near_colour;
  }
  if (is_empty || surface.box.empty()) surface.box = {};
  return surface;
}

bool test(Datapath& path, const Candidates& candidates, Surface& surface) {
  for (std::uint32_t i = surface.first; i < surface.first + surface.count; ++i) {
    const std::vector<TestedHalfspace> tested = path.test(i, candidates.halfspaces[i], surface.box.pixels);
    surface.tested.insert(surface.tested.end(), tested.begin(), tested.end());
  }
  narrow(surface.box, surface.tested);
  return !surface.box.empty();
}

Extremes find_extremes(Datapath& path, const std::vector<TestedHalfspace>& tested, Side side, const Box& box) {
  Extremes result;
  for (const TestedHalfspace& one : tested) {
    if (one.side != side) continue;
    const Containment known = classify_between(one, box.z_low, box.z_high);
    if (known == Containment::in) continue;
    result.is_empty = result.is_empty || known == Containment::out;
    result.facets.push_back(one);
  }
  if (!result.is_empty) remove_hidden_halfspaces(path, result.facets, box.pixels);
  return result;
}

}  // namespace csgsim::division
