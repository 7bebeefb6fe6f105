#pragma once

#include <cstdint>

#include "hw/isa/host_counts.h"
#include "hw/isa/program.h"

namespace csgsim::csg {

/// Where what the host does is counted (docs/host.md). By default nobody counts.
class Counted {
 public:
  Counted() = default;
  /// It has to live as long as this.
  explicit Counted(isa::Preparation& into) : into_(&into) {}

  void add(std::uint64_t isa::Preparation::*kind, std::uint64_t times = 1) const {
    if (into_ != nullptr) into_->*kind += times;
  }

 private:
  isa::Preparation* into_ = nullptr;
};

/// A quadric over a rectangle is worked out from three functions, each at its corners and where it turns.
inline constexpr std::uint64_t tests_of_quadric = 4;

}  // namespace csgsim::csg
