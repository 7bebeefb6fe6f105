#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "sim/software/rays/ray_band.h"

namespace csgsim::software {

/// Every point is evaluated.
template <class Count>
class AllPoints {
 public:
  explicit AllPoints(const Tree& /*tree*/, Count& /*count*/) {}

  void begin_ray() {}

  /// Whether the points behind the first `end` events are in the solid, and those before event `begin` are not;
  /// `evaluate()` finds it out.
  template <class Evaluate>
  bool is_in(std::span<const Event> /*events*/, std::size_t /*begin*/, std::size_t /*end*/, const Evaluate& evaluate,
             Count& /*count*/) {
    return evaluate();
  }

  [[nodiscard]] std::uint64_t words() const { return 0; }
};

}  // namespace csgsim::software
