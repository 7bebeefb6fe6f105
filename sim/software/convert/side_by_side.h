// Bodies that need no division.
// Used by boundary.cpp.
#pragma once

#include <vector>

#include "host/csg/positive_tree.h"
#include "hw/base/work.h"
#include "sim/software/convert/bodies.h"

namespace csgsim::software::convert {

/// Determines for each body whether it and all bodies connected to it by their boxes are combined only by union and lie
/// side by side: any two are separated by the plane of a face of one, or a plane along an edge of each, and if both
/// have a face there, these are in one canonical plane. This holds for a lone primitive and for the pieces of one
/// solid. Their boundary consists of their faces, minus touching parts; nothing needs to be divided. Throws WorkError
/// beyond the work limit.
std::vector<bool> side_by_side(const Bodies& bodies, const csg::PositiveTree& tree, const Work& work);

}  // namespace csgsim::software::convert
