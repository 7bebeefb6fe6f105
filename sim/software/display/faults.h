#pragma once

#include <cstdint>
#include <span>

#include "sim/software/rays/ray_band.h"

namespace csgsim::software {

/// Why a pixel of the list priority algorithm is not as it is to be (thesis 5.2).
enum class Fault : std::uint8_t {
  coincident,  ///< two surfaces are at one depth, or a step apart
  three_way,   ///< three surfaces and more are
  order,       ///< surfaces came in another order than their depths, which are farther apart
};

/// Pixels that differ from the exact picture.
struct Faults {
  std::uint64_t coincident = 0;
  std::uint64_t three_way = 0;
  std::uint64_t order = 0;

  [[nodiscard]] std::uint64_t all() const { return coincident + three_way + order; }
  void add(Fault fault);
};

/// Of a wrong pixel: the ray's events in order, and the surfaces as they were drawn there. If none of these came before
/// one that is more than a step nearer, it is for the surfaces near those that were exchanged, or near the last one.
Fault fault_of(std::span<const Event> exact, std::span<const Event> drawn);

}  // namespace csgsim::software
