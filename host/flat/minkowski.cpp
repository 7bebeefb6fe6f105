#include "host/flat/minkowski.h"

#include <cstdint>
#include <string>
#include <utility>

#include "host/flat/clipping.h"
#include "hw/base/error.h"

namespace csgsim::flat {

namespace {

/// Maximum number of pairs of sides, one of each area.
constexpr std::uint64_t max_pairs = 1'000'000;

std::uint64_t corners(const ClipperLib::Paths& paths) {
  std::uint64_t count = 0;
  for (const ClipperLib::Path& path : paths) count += path.size();
  return count;
}

ClipperLib::IntPoint sum(const ClipperLib::IntPoint& a, const ClipperLib::IntPoint& b) {
  return {a.X + b.X, a.Y + b.Y};
}

/// Adds the area that each side of one path sweeps along each side of the other, as counter-clockwise parallelograms.
void add_swept(ClipperLib::Paths& terms, const ClipperLib::Path& a, const ClipperLib::Path& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const ClipperLib::IntPoint& a_end = a[(i + 1) % a.size()];
    for (std::size_t j = 0; j < b.size(); ++j) {
      const ClipperLib::IntPoint& b_end = b[(j + 1) % b.size()];
      ClipperLib::Path quad{sum(a[i], b[j]), sum(a_end, b[j]), sum(a_end, b_end), sum(a[i], b_end)};
      if (!ClipperLib::Orientation(quad)) ClipperLib::ReversePath(quad);
      terms.push_back(std::move(quad));
    }
  }
}

/// Adds a copy of one area at a corner of each outer path of the other. The copy covers the interior that the sides do
/// not sweep.
void add_inner(ClipperLib::Paths& terms, const ClipperLib::Paths& area, const ClipperLib::Paths& places) {
  for (const ClipperLib::Path& place : places) {
    if (!ClipperLib::Orientation(place)) continue;
    for (const ClipperLib::Path& path : area) {
      ClipperLib::Path moved;
      for (const ClipperLib::IntPoint& corner : path) moved.push_back(sum(corner, place.front()));
      terms.push_back(std::move(moved));
    }
  }
}

Area sum(const Area& one, const Area& other, const Work& work) {
  const ClipperLib::Paths a = to_paths(one);
  const ClipperLib::Paths b = to_paths(other);
  if (corners(a) * corners(b) > max_pairs) {
    throw InputError("minkowski() of 2-D shapes with " + std::to_string(corners(a)) + " and " +
                     std::to_string(corners(b)) + " corners needs more than " + std::to_string(max_pairs) +
                     " pairs of sides; use fewer facets ($fn)");
  }
  ClipperLib::Paths terms;
  for (const ClipperLib::Path& path : b) {
    for (const ClipperLib::Path& around : a) add_swept(terms, around, path);
  }
  add_inner(terms, a, b);
  add_inner(terms, b, a);
  return nonzero_area(terms, work);
}

}  // namespace

Area minkowski(std::span<const Area> areas, const Work& work) {
  if (areas.empty()) return {};
  if (areas.size() == 1) return areas.front();
  Area result = areas.front();
  bool alone = true;
  for (const Area& area : areas.subspan(1)) {
    if (area.empty()) continue;
    result = sum(result, area, work);
    alone = false;
  }
  return alone ? Area{} : result;
}

}  // namespace csgsim::flat
