#include "sim/software/rays/tile_planes.h"

#include <cstddef>

#include "host/csg/locate.h"
#include "host/view/leading.h"
#include "hw/base/error.h"

namespace csgsim::software {

namespace {

using Linear = view::FixedLinear;

/// The planes whose `ranks` (greater means more binding) are maximal somewhere in the tile.
std::vector<Linear> bounding(std::span<const Linear> planes, std::span<const Linear> ranks,
                             const view::PixelRect& tile) {
  const std::vector<bool> leads = view::leading(ranks, tile, 0);
  std::vector<Linear> kept;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (leads[i]) kept.push_back(planes[i]);
  }
  return kept;
}

[[noreturn]] void refuse(const model::Tree& tree, std::uint32_t primitive) {
  throw InputError(
      model::location_text(tree, primitive) +
      ": a face of this primitive is too large for the picture: its coefficients exceed the number range of the "
      "machines; move the camera back, centre the picture on the face, reduce --z-bits or "
      "--fraction-bits, or split the primitive");
}

}  // namespace

TilePlanes planes_of(const model::Tree& tree, const facet::Geometry& geometry, const view::View& view,
                     std::uint32_t primitive) {
  TilePlanes planes;
  const csg::Block anywhere{view.extents[primitive].pixels, 0, (std::int64_t{1} << view.sampling.z_bits) - 1};
  if (anywhere.pixels.empty()) return planes;
  for (const facet::Halfspace halfspace : geometry.solids[primitive].halfspaces) {
    const view::ScreenPlane& plane = view.planes[halfspace.plane];
    if (!plane.representable) {
      const csg::Containment known = csg::locate(view, halfspace, anywhere);
      if (known == csg::Containment::depends) refuse(tree, primitive);
      planes.nowhere = planes.nowhere || known == csg::Containment::out;
      continue;
    }
    switch (view::side_of(plane, halfspace)) {
      case view::Side::front: planes.fronts.push_back(plane.linear); break;
      case view::Side::back: planes.backs.push_back(plane.linear); break;
      case view::Side::edge_positive: planes.edges.push_back({plane.linear, true}); break;
      case view::Side::edge_negative: planes.edges.push_back({plane.linear, false}); break;
    }
  }
  return planes;
}

std::uint64_t select_bounding(const TilePlanes& planes, const view::PixelRect& tile, TilePlanes& selected) {
  std::vector<Linear> nearness;  // negated back planes
  nearness.reserve(planes.backs.size());
  for (const Linear& back : planes.backs) nearness.push_back({-back.a, -back.b, -back.c});
  selected.fronts = bounding(planes.fronts, planes.fronts, tile);
  selected.backs = bounding(planes.backs, nearness, tile);
  return planes.fronts.size() + planes.backs.size();
}

}  // namespace csgsim::software
