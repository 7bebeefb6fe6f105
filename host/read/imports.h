#pragma once

#include <string_view>

#include "host/flat/area.h"
#include "host/read/arguments.h"
#include "host/read/operands.h"

namespace csgsim::read {

// Nodes that other files stand for, see Arguments::file().

/// What a DXF file draws, as the arguments `layer`, `origin` and $fn, $fa, $fs say. Throws InputError without a place.
flat::Area dxf_area(const Arguments& arguments, std::string_view bytes, double scale);

/// import() of STL, OFF, AMF, 3MF, SVG and DXF files.
Maker read_import(const Arguments& arguments);

/// surface() of numbers and pictures.
Maker read_surface(const Arguments& arguments);

}  // namespace csgsim::read
