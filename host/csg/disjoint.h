#pragma once

#include <cstdint>

#include "host/csg/pruning.h"
#include "host/facet/scene.h"
#include "host/view/projection.h"

namespace csgsim::csg {

bool disjoint(const facet::Box& a, const facet::Box& b);

/// Whether two primitives surely have no point of the picture and depth range in common, by the prunings asked for.
bool disjoint(const view::View& view, std::uint32_t a, std::uint32_t b, const Pruning& pruning);

}  // namespace csgsim::csg
