#include "host/flat/offset.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "host/flat/clip_steps.h"
#include "host/flat/clipping.h"
#include "host/model/degrees.h"
#include "host/model/fragments.h"
#include "hw/base/error.h"

namespace csgsim::flat {

namespace {

/// Corners that a round offset may make before sides are joined.
constexpr std::uint64_t max_round_corners = 4'000'000;

/// Sides are drawn out to this many times the distance: as good as any.
constexpr double sharp_limit = 1e6;

/// Sides that are drawn out stay within what Clipper's integers hold then.
constexpr double largest_distance = 1e7;

/// Indexed by Corner.
constexpr std::array join_types{ClipperLib::jtRound, ClipperLib::jtMiter, ClipperLib::jtSquare};

/// How far arcs of that radius may be from their chords, for Clipper to make as many of them as OpenSCAD wants.
double arc_tolerance(const Area& area, double radius, const model::FacetControl& facets) {
  const std::uint32_t fragments = model::fragments(radius, facets);
  std::uint64_t corners = 0;
  for (const Outline& outline : area.outlines) corners += outline.size();
  if (corners * fragments > max_round_corners) {
    throw InputError("offset() of a shape with " + std::to_string(corners) + " corners by arcs of " +
                     std::to_string(fragments) + " fragments is too much; ask for fewer with $fn");
  }
  return radius * (1 - model::cos_degrees(180.0 / fragments));
}

}  // namespace

Area offset(const Area& area, double distance, Corner corner, const model::FacetControl& facets, const Work& work) {
  if (!(std::abs(distance) <= largest_distance)) {
    throw InputError("the distance of offset() is not a number or beyond 1e7; make it smaller");
  }
  const double tolerance = corner == Corner::round ? arc_tolerance(area, std::abs(distance), facets) : 0;
  ClipperLib::ClipperOffset clipper(sharp_limit, tolerance * clipper_scale);
  const ClipperLib::Paths paths = paths_of(area);
  charge_clipping(paths, work);
  clipper.AddPaths(paths, join_types.at(static_cast<std::size_t>(corner)), ClipperLib::etClosedPolygon);
  ClipperLib::PolyTree tree;
  clipper.Execute(tree, distance * clipper_scale);
  return area_of(tree);
}

}  // namespace csgsim::flat
