// Width of plane values in longs.
// Used to count operations of software.
#pragma once

#include <cstdint>

#include "host/view/projection.h"

namespace csgsim::software {

/// Number of 32-bit longs of a plane's value: depth, fraction, a sign, and a bit for sums.
constexpr std::uint64_t longs_of(const view::Sampling& sampling) {
  constexpr unsigned long_bits = 32;
  return (sampling.z_bits + sampling.fraction_bits + 2 + long_bits - 1) / long_bits;
}

}  // namespace csgsim::software
