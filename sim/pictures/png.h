#pragma once

#include "sim/pictures/module.h"

namespace csgsim::pictures {

/// A PNG file of 8 bits a channel.
Encoded encode_png(const Raster& raster, Bytes bytes);

}  // namespace csgsim::pictures
