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

/// Maximum number of corners of a round offset before its sides are joined.
constexpr std::uint64_t max_round_corners = 4'000'000;

/// Sharp corners are cut off at this multiple of the distance, which practically never occurs.
constexpr double sharp_limit = 1e6;

/// Keeps extended sides within the range of Clipper's integers.
constexpr double max_distance = 1e7;

/// Indexed by Corner.
constexpr std::array join_types{ClipperLib::jtRound, ClipperLib::jtMiter, ClipperLib::jtSquare};

/// The maximum distance of an arc from its chords for which Clipper uses OpenSCAD's number of fragments.
double arc_tolerance(const Area& area, double radius, const model::FacetControl& facets) {
  const std::uint32_t fragments = model::fragments(radius, facets);
  std::uint64_t corners = 0;
  for (const Outline& outline : area.outlines) corners += outline.size();
  if (corners * fragments > max_round_corners) {
    throw InputError("offset() of a shape with " + std::to_string(corners) + " corners by arcs of " +
                     std::to_string(fragments) + " fragments makes too many corners; use fewer facets ($fn)");
  }
  return radius * (1 - model::cos_degrees(180.0 / fragments));
}

}  // namespace

Area offset(const Area& area, double distance, Corner corner, const model::FacetControl& facets, const Work& work) {
  if (!(std::abs(distance) <= max_distance)) {
    throw InputError("the distance of offset() is not a number or exceeds 1e7; make it smaller");
  }
  const double tolerance = corner == Corner::round ? arc_tolerance(area, std::abs(distance), facets) : 0;
  ClipperLib::ClipperOffset clipper(sharp_limit, tolerance * clipper_scale);
  const ClipperLib::Paths paths = to_paths(area);
  charge_clipping(paths, work);
  clipper.AddPaths(paths, join_types.at(static_cast<std::size_t>(corner)), ClipperLib::etClosedPolygon);
  ClipperLib::PolyTree tree;
  clipper.Execute(tree, distance * clipper_scale);
  return to_area(tree);
}

}  // namespace csgsim::flat
