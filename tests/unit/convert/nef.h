#pragma once

#include "host/model/tree.h"

namespace csgsim::testing {

/// The volume of what a tree leaves of its primitives' convex hulls, by CGAL's Nef polyhedra of rational numbers.
double nef_volume(const model::Tree& tree);

}  // namespace csgsim::testing
