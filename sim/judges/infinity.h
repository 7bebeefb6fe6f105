#pragma once

#include <limits>

namespace csgsim::judges {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace csgsim::judges
