// OpenSCAD's number of slices of an extrusion.
// Used by bent_slices.cpp.
#pragma once

#include <cstdint>

#include "host/flat/area.h"
#include "host/solids/extrusion.h"

namespace csgsim::solids {

/// Number of slices of an extrusion with bent sides, as in OpenSCAD 2021.01. If `slices` is given, it is used. With a
/// twist, the number follows from the path of the outermost corner (a helix or conical helix) and $fs, and from the
/// twist and $fa or $fn. Otherwise, if x and y scale differently, it follows from the longest path of a corner and $fs,
/// or from $fn. Throws InputError if the slices would have more than 4,000,000 faces.
std::uint32_t slice_count(const flat::Area& area, const LinearExtrude& extrusion);

}  // namespace csgsim::solids
