// Choice of the planes by which a solid is cut into convex pieces.
// Used by partition.cpp.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "host/facet/planes.h"
#include "host/solids/partition.h"
#include "hw/base/work.h"

namespace csgsim::solids {

/// Inputs to the choice of a cutting plane, in addition to the cell's surface.
struct Choices {
  std::span<const Level> levels;  ///< sorted by axis and place
  const facet::PlaneTable& planes;
  double near = 0;  ///< points closer to a plane than this, in model units, count as on it
  const Work& work;
};

/// Chooses the plane that cuts a cell: the plane of a face with a reflex edge, of any face, or a level. Prefers planes
/// that cut few faces and contain many reflex edges. Empty if the surface in the cell is convex. Throws WorkError if
/// the work limit is exceeded.
std::optional<facet::Halfspace> choose_plane(const Soup& soup, const Choices& choices);

/// Sorts by plane and side, and removes duplicates.
void sort_unique(std::vector<facet::Halfspace>& halfspaces);

}  // namespace csgsim::solids
