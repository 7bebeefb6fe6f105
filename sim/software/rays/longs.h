#pragma once

#include <cstdint>

#include "host/view/projection.h"

namespace csgsim::software {

/// Longs that a plane's value needs: depth and fraction, a sign, and a bit for sums.
constexpr std::uint64_t longs_of(const view::Sampling& sampling) {
  constexpr unsigned long_bits = 32;
  return (sampling.z_bits + sampling.fraction_bits + 2 + long_bits - 1) / long_bits;
}

}  // namespace csgsim::software
