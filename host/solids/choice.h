#pragma once

#include <optional>
#include <span>
#include <vector>

#include "host/facet/planes.h"
#include "host/solids/partition.h"
#include "hw/base/work.h"

namespace csgsim::solids {

/// What the plane to cut a cell by is chosen from, besides the cell's surface.
struct Choices {
  std::span<const Level> levels;  ///< in order of axis and place
  const facet::PlaneTable& planes;
  double near = 0;  ///< points nearer to a plane, in model units, are on it
  const Work& work;
};

/// The plane to cut a cell by: of a face with a reflex edge, of any face, or a level, that cuts few faces and holds
/// many reflex edges. None if the surface in the cell is convex. Throws WorkError past the limit on work.
std::optional<facet::Halfspace> choose_plane(const Soup& soup, const Choices& choices);

/// Sorts by plane and side, and keeps each once.
void sort_unique(std::vector<facet::Halfspace>& halfspaces);

}  // namespace csgsim::solids
