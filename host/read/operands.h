// Operands and results of nodes other than Booleans.
// Used by node_readers.h and nodes.h.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "host/flat/area.h"
#include "host/model/tree.h"
#include "hw/base/work.h"

namespace csgsim::read {

/// The children of a node that is not a Boolean, in the node's own space.
struct Operands {
  std::vector<flat::Area> areas;    ///< one per child, if the children are flat; empty for a child without an area
  std::vector<model::Tree> solids;  ///< one per non-empty child
  std::uint32_t dimensions = 0;     ///< dimensions of the children; 0 if no child has any
  Work work{};                      ///< is charged for making the node
};

/// The result of a node that is not a Boolean, in the node's own space: a solid as convex pieces, an area, or neither.
struct NodeResult {
  std::vector<model::Polyhedron> pieces{};
  flat::Area area{};
  std::vector<model::Polyhedron> holes{};  ///< solids subtracted from the first and only piece
  /// Also set if the result is empty; 0 if there is no result, as for a group() without children.
  std::uint32_t dimensions = 0;
  std::vector<std::string> warnings{};  ///< texts of warnings, without a position
};

/// The union of the children that are areas.
flat::Area union_of_areas(const Operands& operands);

/// Whether the union of the children that are areas is an area, possibly empty. As in OpenSCAD, a single empty child
/// gives no area.
bool has_area(const Operands& operands);

/// The union of the children that are solids; the tree has no nodes if there are none.
model::Tree union_of_solids(Operands operands);

/// Makes the result of a node from its operands, when the node ends. Throws InputError without a position.
using Maker = std::function<NodeResult(Operands)>;

}  // namespace csgsim::read
