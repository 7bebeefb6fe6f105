#pragma once

#include <cstdint>

namespace csgsim::raster {

struct Figures {
  std::uint32_t pixel_clocks = 1;  ///< of an instruction at a pixel
};

}  // namespace csgsim::raster
