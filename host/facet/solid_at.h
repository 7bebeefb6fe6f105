#pragma once

#include <cstdint>

#include "host/facet/faceting.h"
#include "host/facet/solid.h"
#include "host/model/tree.h"

namespace csgsim::facet {

/// A primitive of a tree, as make_solid() makes it. Throws InputError, naming the primitive's place in the file, where
/// it cannot be faceted or reaches farther than model::most_coordinate.
Solid make_solid_at(const model::Tree& tree, std::uint32_t primitive, const Faceting& faceting);

}  // namespace csgsim::facet
