#pragma once

#include <cstdint>

namespace csgsim::raster {

struct Figures {
  std::uint32_t pixel_clocks = 1;  ///< clocks of an instruction per pixel
};

}  // namespace csgsim::raster
