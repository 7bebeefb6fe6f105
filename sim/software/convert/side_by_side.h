#pragma once

#include <vector>

#include "host/csg/positive_tree.h"
#include "hw/base/work.h"
#include "sim/software/convert/bodies.h"

namespace csgsim::software::convert {

/// Of each body, whether it and all that hang together with it by their boxes are united alone, and lie side by side:
/// of any two, a plane of a face of one, or along an edge of each, is between them, and where both have a face there,
/// these are in one canonical plane. So are a lone primitive and the pieces of one solid. Their faces, less what one
/// has against another, are the boundary there; nothing has to be divided. Throws WorkError past the limit on work.
std::vector<bool> side_by_side(const Bodies& bodies, const csg::PositiveTree& tree, const Work& work);

}  // namespace csgsim::software::convert
