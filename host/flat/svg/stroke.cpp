#include "host/flat/svg/stroke.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <polyclipping/clipper.hpp>

#include "hw/base/error.h"

namespace csgsim::flat::svg {

namespace {

/// OpenSCAD's units per unit of the drawing; values are truncated towards 0.
constexpr double scale = 10'000;

/// Maximum coordinate, in Clipper's units, for which sums do not overflow.
constexpr double largest = 1e15;

/// Clipper's default for the distance of arcs from their chords, in its units.
constexpr double arc_tolerance = 0.25;

// Indexed by Cap and Join.
constexpr std::array end_types{ClipperLib::etOpenButt, ClipperLib::etOpenRound, ClipperLib::etOpenSquare};
constexpr std::array join_kinds{ClipperLib::jtSquare, ClipperLib::jtRound, ClipperLib::jtMiter};

ClipperLib::cInt units(double coordinate) {
  if (!(std::abs(coordinate) * scale <= largest))
    throw InputError("a line of the drawing is too far from the origin; move it closer");
  return static_cast<ClipperLib::cInt>(coordinate * scale);
}

void check_corners(const Outline& line, const Stroke& stroke, double radius, std::size_t max_corners) {
  const bool round = stroke.cap == Cap::round || stroke.join == Join::round;
  const double around = round && radius > 1 ? std::numbers::pi / std::acos(1 - arc_tolerance / radius) : 4;
  if (around * static_cast<double>(line.size()) > static_cast<double>(max_corners)) {
    throw InputError(
        "a line of the drawing has too many corners or too wide a stroke; simplify it, or make the stroke narrower");
  }
}

}  // namespace

std::vector<Outline> stroke_outlines(const Outline& line, const Stroke& stroke, std::size_t max_corners) {
  const double radius = stroke.width * scale / 2;
  if (!(radius <= largest)) throw InputError("a stroke of the drawing is too wide; make it narrower");
  check_corners(line, stroke, radius, max_corners);
  ClipperLib::Path path;
  for (const glm::dvec2& corner : line) path.emplace_back(units(corner.x), units(corner.y));
  ClipperLib::ClipperOffset offset;
  offset.AddPath(path, join_kinds.at(static_cast<std::size_t>(stroke.join)),
                 end_types.at(static_cast<std::size_t>(stroke.cap)));
  ClipperLib::Paths around;
  offset.Execute(around, radius);
  std::vector<Outline> result;
  for (const ClipperLib::Path& found : around) {
    Outline& outline = result.emplace_back();
    for (const ClipperLib::IntPoint& point : found) {
      outline.emplace_back(static_cast<double>(point.X) / scale, static_cast<double>(point.Y) / scale);
    }
  }
  return result;
}

}  // namespace csgsim::flat::svg
