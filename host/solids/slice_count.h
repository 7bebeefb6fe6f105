#pragma once

#include <cstdint>

#include "host/flat/area.h"
#include "host/solids/extrusion.h"

namespace csgsim::solids {

/// Slices of an extrusion whose sides bend, as OpenSCAD 2021.01 counts them. As many as the extrusion says; else with a
/// twist by the length of the helix, or conical helix, that the outermost corner runs along, against $fs, and by the
/// twist against $fa or $fn; else, if x and y scale differently, by the longest way of a corner against $fs, or $fn.
/// Throws InputError if the slices would have more than 4,000,000 faces.
std::uint32_t slice_count(const flat::Area& area, const LinearExtrude& extrusion);

}  // namespace csgsim::solids
