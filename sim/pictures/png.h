// Encodes PNG files with libpng.
// Used by encode.cpp.
#pragma once

#include "sim/pictures/module.h"

namespace csgsim::pictures {

/// Encodes a PNG file with 8 bits per channel.
Encoded encode_png(const Raster& raster, Bytes bytes);

}  // namespace csgsim::pictures
