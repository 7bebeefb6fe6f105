#include "host/flat/combine.h"

#include <cstddef>

#include "host/flat/clipping.h"

namespace csgsim::flat {

namespace {

/// The paths of a tree. Iterative, because trees may be deep.
ClipperLib::Paths contours(const ClipperLib::PolyTree& tree) {
  ClipperLib::Paths paths;
  for (const ClipperLib::PolyNode* node = tree.GetFirst(); node != nullptr; node = node->GetNext()) {
    paths.push_back(node->Contour);
  }
  return paths;
}

}  // namespace

Area unite(std::span<const Area> areas, const Work& work) {
  if (areas.empty()) return {};
  return areas.size() == 1 ? areas.front() : combined(areas, ClipperLib::ctUnion, work);
}

Area subtract(std::span<const Area> areas, const Work& work) {
  if (areas.empty()) return {};
  return areas.size() == 1 ? areas.front() : combined(areas, ClipperLib::ctDifference, work);
}

Area intersect(std::span<const Area> areas, const Work& work) {
  if (areas.empty()) return {};
  if (areas.size() == 1) return areas.front();
  ClipperLib::Paths common = to_paths(areas.front());
  ClipperLib::PolyTree result;
  for (const Area& area : areas.subspan(1)) {
    Clipping clipping;
    clipping.add(common);
    clipping.add(to_paths(area));
    clipping.execute(ClipperLib::ctIntersection, ClipperLib::pftNonZero, result, work);
    common = contours(result);
  }
  return to_area(result);
}

}  // namespace csgsim::flat
