#pragma once

#include "hw/isa/program.h"

namespace csgsim::bench {

/// A Program for an array of that shape that repeats `primitives` times the work of a CSG depth-buffer program for a
/// box of six half-spaces: render it, classify it against another, combine, merge, shade.
isa::Program typical_mix(isa::ArrayShape shape, unsigned primitives);

}  // namespace csgsim::bench
