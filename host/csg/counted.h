// An optional counter of host work.
// Used by pruning and the emitter.
#pragma once

#include <cstdint>

#include "hw/isa/host_counts.h"
#include "hw/isa/program.h"

namespace csgsim::csg {

/// Counts host work (docs/host.md) if constructed with a destination.
class Counted {
 public:
  Counted() = default;
  /// `into` must outlive this object.
  explicit Counted(isa::Preparation& into) : into_(&into) {}

  void add(std::uint64_t isa::Preparation::*kind, std::uint64_t times = 1) const {
    if (into_ != nullptr) into_->*kind += times;
  }

 private:
  isa::Preparation* into_ = nullptr;
};

/// Testing a quadric over a rectangle evaluates three functions, each at its corners and its turning points.
inline constexpr std::uint64_t tests_of_quadric = 4;

}  // namespace csgsim::csg
