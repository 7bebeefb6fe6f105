#include "host/flat/clipping.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include "host/flat/clip_steps.h"
#include "host/flat/overlaps.h"
#include "hw/base/error.h"

namespace csgsim::flat {

namespace {

ClipperLib::cInt units(double coordinate) {
  if (!(std::abs(coordinate) <= largest_coordinate)) {
    throw InputError("a coordinate of a 2-D shape is not a number or exceeds 1e12; scale the shape down");
  }
  return static_cast<ClipperLib::cInt>(coordinate * clipper_scale);
}

Outline to_outline(const ClipperLib::Path& path) {
  Outline outline;
  outline.reserve(path.size());
  for (const ClipperLib::IntPoint& point : path) {
    outline.emplace_back(static_cast<double>(point.X) / clipper_scale, static_cast<double>(point.Y) / clipper_scale);
  }
  return outline;
}

/// Whether Clipper received no path with an area, which it would report as a failure.
bool is_empty(ClipperLib::Clipper& clipper) {
  const ClipperLib::IntRect box = clipper.GetBounds();
  return box.left == box.right && box.top == box.bottom;
}

bool is_before(const Area& one, const Area& other) {
  const auto is_lower = [](const glm::dvec2& a, const glm::dvec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
  return std::ranges::lexicographical_compare(one.outlines, other.outlines, [&](const Outline& a, const Outline& b) {
    return std::ranges::lexicographical_compare(a, b, is_lower);
  });
}

/// The distinct areas, in order. Repeated areas are omitted because Clipper is slow where sides coincide.
std::vector<const Area*> without_repeats(std::span<const Area> areas) {
  const auto is_less = [](const Area* a, const Area* b) { return is_before(*a, *b); };
  std::set<const Area*, decltype(is_less)> seen(is_less);
  std::vector<const Area*> once;
  for (const Area& area : areas) {
    if (seen.insert(&area).second) once.push_back(&area);
  }
  return once;
}

Area united(const ClipperLib::Paths& paths, ClipperLib::PolyFillType rule, const Work& work) {
  Clipping clipping;
  clipping.add(paths);
  ClipperLib::PolyTree tree;
  clipping.execute(ClipperLib::ctUnion, rule, tree, work);
  return to_area(tree);
}

}  // namespace

ClipperLib::Path to_path(const Outline& outline) {
  ClipperLib::Path path;
  path.reserve(outline.size());
  for (const glm::dvec2& corner : outline) path.emplace_back(units(corner.x), units(corner.y));
  return path;
}

ClipperLib::Paths to_paths(const Area& area) {
  ClipperLib::Paths paths;
  paths.reserve(area.outlines.size());
  for (const Outline& outline : area.outlines) paths.push_back(to_path(outline));
  return paths;
}

void Clipping::add(ClipperLib::Paths paths) {
  clipper_.AddPaths(paths, std::exchange(type_, ClipperLib::ptClip), true);
  std::move(paths.begin(), paths.end(), std::back_inserter(paths_));
}

void Clipping::execute(ClipperLib::ClipType operation, ClipperLib::PolyFillType rule, ClipperLib::PolyTree& result,
                       const Work& work) {
  result.Clear();
  if (is_empty(clipper_)) return;
  charge_clipping(paths_, work);
  bool done = false;
  try {
    done = clipper_.Execute(operation, result, rule, rule);
  } catch (const ClipperLib::clipperException&) {
    done = false;
  }
  if (!done) throw InputError("the 2-D shapes cannot be combined because their sides cross; simplify them");
}

Area to_area(const ClipperLib::PolyTree& tree) {
  Area area;
  ClipperLib::Path cleaned;
  for (const ClipperLib::PolyNode* node = tree.GetFirst(); node != nullptr; node = node->GetNext()) {
    ClipperLib::CleanPolygon(node->Contour, cleaned);
    if (cleaned.size() >= 3) area.outlines.push_back(to_outline(cleaned));
  }
  return area;
}

Area combined(std::span<const Area> areas, ClipperLib::ClipType operation, const Work& work) {
  if (areas.empty()) return {};
  Clipping clipping;
  clipping.add(to_paths(areas.front()));
  for (const Area* const area : without_repeats(areas.subspan(1))) clipping.add(to_paths(*area));
  ClipperLib::PolyTree result;
  clipping.execute(operation, ClipperLib::pftNonZero, result, work);
  return to_area(result);
}

Area even_odd_area(const ClipperLib::Paths& paths, const Work& work) {
  return united(remove_coincident_sides(paths, work), ClipperLib::pftEvenOdd, work);
}

Area nonzero_area(const ClipperLib::Paths& paths, const Work& work) {
  return united(paths, ClipperLib::pftNonZero, work);
}

}  // namespace csgsim::flat
