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
  std::vector<flat::Area> areas;    ///< if flat children count: one per child, empty if it does not count
  std::vector<model::Tree> solids;  ///< one per child that is not empty
  std::uint32_t dimensions = 0;     ///< dimensions of the children that count; 0 if none has any
  Work work{};                      ///< charged for making the node
};

/// The result of such a node, in its own space: a solid as convex pieces, an area, or nothing.
struct Made {
  std::vector<model::Polyhedron> pieces{};
  flat::Area area{};
  std::vector<model::Polyhedron> holes{};  ///< subtracted from the only piece
  std::uint32_t dimensions = 0;            ///< kept even if empty; 0: no result, as for a group() without any
  std::vector<std::string> warnings{};     ///< texts without a position
};

/// The union of the children that are areas.
flat::Area only_area(const Operands& operands);

/// Whether that union is an area, possibly empty. As in OpenSCAD, a single empty child gives no area.
bool has_area(const Operands& operands);

/// The union of the children that are solids; without nodes if there are none.
model::Tree only_solid(Operands operands);

/// Makes the result when the node ends. Throws InputError without a position.
using Maker = std::function<Made(Operands)>;

}  // namespace csgsim::read
