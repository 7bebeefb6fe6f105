#pragma once

#include "host/model/tree.h"

namespace csgsim::testing {

/// Volume of a tree of the convex hulls of its primitives, computed with CGAL's Nef polyhedra in rational arithmetic.
double nef_volume(const model::Tree& tree);

}  // namespace csgsim::testing
