#pragma once

#include <functional>
#include <vector>

#include "host/flat/area.h"
#include "host/model/tree.h"

namespace csgsim::read {

/// What the children of a node that is not a Boolean are, in the node's own space. Empty ones are left out.
struct Operands {
  std::vector<flat::Area> areas;
  std::vector<model::Tree> solids;  ///< one a child
};

/// What such a node is, in its own space: a solid in convex pieces, or an area, or nothing.
struct Made {
  std::vector<model::Polyhedron> pieces{};
  flat::Area area{};
  std::vector<model::Polyhedron> holes{};  ///< taken away from the one piece
};

/// Makes it when the node has ended. Throws InputError without a place.
using Maker = std::function<Made(Operands)>;

}  // namespace csgsim::read
