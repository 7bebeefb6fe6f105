#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "host/flat/area.h"
#include "host/model/tree.h"
#include "hw/base/work.h"

namespace csgsim::read {

/// What the children of a node that is not a Boolean are, in the node's own space.
struct Operands {
  std::vector<flat::Area> areas;    ///< where flat children count: one a child, empty if it is or does not count
  std::vector<model::Tree> solids;  ///< one a child that is not empty
  std::uint32_t dimensions = 0;     ///< of the children that count; 0 if none has any
  Work work{};                      ///< that making the node is charged to
};

/// What such a node is, in its own space: a solid in convex pieces, or an area, or nothing.
struct Made {
  std::vector<model::Polyhedron> pieces{};
  flat::Area area{};
  std::vector<model::Polyhedron> holes{};  ///< taken away from the one piece
  std::uint32_t dimensions =
      0;  ///< that it has though it is empty; 0 if it is nothing then, as a group() of nothing is
  std::vector<std::string> warnings{};  ///< without a place
};

/// The union of children that are areas.
flat::Area only_area(const Operands& operands);

/// Whether that union is an area, if an empty one. As in OpenSCAD a single child that is empty is nothing at all.
bool has_area(const Operands& operands);

/// The union of children that are solids, of no nodes if there are none.
model::Tree only_solid(Operands operands);

/// Makes it when the node has ended. Throws InputError without a place.
using Maker = std::function<Made(Operands)>;

}  // namespace csgsim::read
