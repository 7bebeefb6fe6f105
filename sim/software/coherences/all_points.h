// Coherence that evaluates all points.
// One of the rows of coherences().
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "sim/software/rays/ray_band.h"

namespace csgsim::software {

/// Evaluates every point.
template <class Count>
class AllPoints {
 public:
  explicit AllPoints(const Tree& /*tree*/, Count& /*count*/) {}

  void begin_ray() {}

  /// Whether the points after the first `end` events are inside the solid, given that those before event `begin` are
  /// not; `evaluate()` computes it.
  template <class Evaluate>
  bool is_in(std::span<const Event> /*events*/, std::size_t /*begin*/, std::size_t /*end*/, const Evaluate& evaluate,
             Count& /*count*/) {
    return evaluate();
  }

  [[nodiscard]] std::uint64_t words() const { return 0; }
};

}  // namespace csgsim::software
