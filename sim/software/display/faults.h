#pragma once

#include <cstdint>
#include <span>

#include "sim/software/rays/ray_band.h"

namespace csgsim::software {

/// Why a pixel of the list priority algorithm is not as it is to be (thesis 5.2). Surfaces coincide if they are at one
/// depth, in real numbers.
enum class Fault : std::uint8_t {
  depth_bits,  ///< surfaces came in the order of their real depths, or rounding hides it; integers say otherwise
  coincident,  ///< two surfaces coincide
  three_way,   ///< two coincide, and a third is where they are by integers, or a step from there
  order,       ///< surfaces came in another order than their real depths, which are too far apart for that
};

/// Pixels that differ from the exact picture.
struct Faults {
  std::uint64_t depth_bits = 0;
  std::uint64_t coincident = 0;
  std::uint64_t three_way = 0;
  std::uint64_t order = 0;

  [[nodiscard]] std::uint64_t all() const { return depth_bits + coincident + three_way + order; }
  void add(Fault fault);
};

/// The ray of a wrong pixel.
struct WrongRay {
  std::span<const Event> events;   ///< in order of their integers, those that were drawn
  std::span<const double> depths;  ///< of these, real, in steps (RealDepths)
  double rounding = 0;             ///< steps that two depths may seem to be apart less, or more
  bool has_lost = false;           ///< others were not drawn, since rounding took them far from their cells
};

/// `drawn`: the surfaces as they were drawn there. The pixel is wrong for those that came before a nearer one by
/// integers, or for the last one if another is at its depth; of several reasons, for the last in Fault. If for none, it
/// is for what was not drawn.
Fault fault_of(const WrongRay& ray, std::span<const Event> drawn);

}  // namespace csgsim::software
