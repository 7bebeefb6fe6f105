#include "hw/division/surfaces.h"

#include <algorithm>

#include "hw/division/cells.h"

namespace csgsim::division {

namespace {

/// The part of the square that all the primitives' boxes have in common.
Box common_box(const DisplayModel& model, const Candidates& candidates, std::uint32_t first, std::uint32_t count,
               const Rectangle& square) {
  Box box{square, 0, model.farthest()};
  for (std::uint32_t i = first; i < first + count; ++i) {
    if (!candidates.listed[i]) return {};
    const Box& own = model.primitives[i].box;
    if (own.empty()) return {};
    box.pixels = overlap(box.pixels, own.pixels);
    box.z_low = std::max(box.z_low, own.z_low);
    box.z_high = std::min(box.z_high, own.z_high);
  }
  return box.empty() ? Box{} : box;
}

/// Narrows the depths to those between the fronts and backs at the corners; none, if an edge holds nothing.
void narrow(Box& box, const std::vector<Tested>& tested) {
  bool nothing = false;
  for (const Tested& one : tested) {
    switch (one.side) {
      case Side::front: box.z_low = std::max(box.z_low, one.low); break;
      case Side::back: box.z_high = std::min(box.z_high, one.high); break;
      case Side::not_negative:
      case Side::negative: nothing = nothing || known_between(one, box.z_low, box.z_high) == Known::out; break;
    }
  }
  if (nothing) box.z_high = box.z_low - 1;
}

}  // namespace

std::uint32_t joined_from(const DisplayModel& model, std::uint32_t first) {
  std::uint32_t next = first + 1;
  while (next < model.primitives.size() && model.primitives[next].joined) ++next;
  return next - first;
}

std::optional<Surface> surface_in(const DisplayModel& model, const Candidates& candidates, std::uint32_t first,
                                  std::uint32_t count, const Rectangle& square, Counts& counts) {
  Surface surface{first, count, common_box(model, candidates, first, count, square), {}};
  if (surface.box.empty()) return std::nullopt;
  for (std::uint32_t i = first; i < first + count; ++i) {
    for (const Halfspace& halfspace : candidates.halfspaces[i]) {
      surface.tested.push_back(test_corners(model, i, halfspace, surface.box.pixels));
    }
  }
  counts.halfspaces += surface.tested.size();
  narrow(surface.box, surface.tested);
  if (surface.box.empty()) return std::nullopt;
  return surface;
}

Extremes extremes_of(const DisplayModel& model, const std::vector<Tested>& tested, Side side, const Box& box,
                     Counts& counts) {
  Extremes result;
  for (const Tested& one : tested) {
    if (one.side != side) continue;
    const Known known = known_between(one, box.z_low, box.z_high);
    if (known == Known::in) continue;
    result.nothing = result.nothing || known == Known::out;
    result.facets.push_back(one);
  }
  if (!result.nothing) counts.cells += keep_extremes(model, result.facets, box.pixels);
  return result;
}

}  // namespace csgsim::division
