// Faceting of one primitive of a tree, with positions in errors.
// Used by geometry.cpp and sim/software.
#pragma once

#include <cstdint>

#include "host/facet/faceting.h"
#include "host/facet/solid.h"
#include "host/model/tree.h"

namespace csgsim::facet {

/// Calls make_solid() for a primitive of a tree. Throws InputError, with the primitive's position in the file, if it
/// cannot be faceted or reaches farther than model::max_coordinate.
Solid make_solid_at(const model::Tree& tree, std::uint32_t primitive, const Faceting& faceting);

}  // namespace csgsim::facet
