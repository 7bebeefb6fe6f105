// Causes of wrong pixels.
// Used by list priority.
#pragma once

#include <cstdint>
#include <span>

#include "sim/software/rays/ray_band.h"

namespace csgsim::software {

/// Cause of a wrong pixel of the list priority algorithm (thesis 5.2). Surfaces coincide if their real depths are
/// equal.
enum class Fault : std::uint8_t {
  depth_bits,  ///< surfaces were in the order of their real depths (or within rounding), but integers order them
               ///< differently
  coincident,  ///< two surfaces coincide
  three_way,   ///< two surfaces coincide, and a third has the same integer depth or differs by one step
  order,       ///< surfaces were not in the order of their real depths, by more than rounding explains
};

/// Number of pixels that differ from the exact picture.
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
  std::span<const Event> events;   ///< drawn events, sorted by integer depth
  std::span<const double> depths;  ///< their real depths in steps (RealDepths)
  double rounding = 0;             ///< maximum error, in steps, of the difference between two depths
  bool has_lost = false;           ///< some events were not drawn, because rounding moved them far from their cells
};

/// The cause of a wrong pixel. `drawn`: the surfaces in drawing order. A surface is at fault if it was drawn before one
/// with a smaller integer depth, or if it is the last and shares its depth. Of several causes, the last one in Fault is
/// returned. If no drawn surface is at fault, the cause is depth_bits if the ray has lost events, and otherwise order.
Fault fault_of(const WrongRay& ray, std::span<const Event> drawn);

}  // namespace csgsim::software
