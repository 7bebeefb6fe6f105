#pragma once

#include <span>

#include "sim/studies/subdivide/measure.h"

namespace csgsim::studies {

/// A column a row, as in tables 7.2 and 7.3 of the thesis; of a machine that tells stages with the thesis's own.
void print_subdivision(std::span<const SubdivideRow> rows);

}  // namespace csgsim::studies
