// An optional counter of host work.
// Used by host/emit.
#pragma once

#include <cstdint>

#include "host/csg/tested.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/program.h"

namespace csgsim::csg {

/// Counts host work (docs/host.md) if constructed with a destination.
class Counted {
 public:
  Counted() = default;
  /// `work` and `tested`, which may be null, must outlive this object.
  explicit Counted(isa::Preparation& work, Tested* tested = nullptr) : into_(&work), tested_(tested) {}

  void add(std::uint64_t isa::Preparation::*kind, std::uint64_t times = 1) const {
    if (into_ != nullptr) into_->*kind += times;
  }

  /// Counts the test of a plane over a rectangle, or, if it has been tested there before, the comparison of rectangles
  /// that finds its extremes.
  void test(const view::FixedLinear& plane, const view::PixelRect& pixels) const {
    if (!test_if_new(plane, pixels)) add(&isa::Preparation::boxes);
  }

  /// Counts the test of a plane over a rectangle unless its extremes there are at hand. Returns whether it was new.
  bool test_if_new(const view::FixedLinear& plane, const view::PixelRect& pixels) const {
    constexpr std::uint64_t values_of_row = 2;
    if (into_ == nullptr) return false;
    switch (tested_ == nullptr ? ExtremesSource::by_test : tested_->add(plane, pixels)) {
      case ExtremesSource::by_test: add(&isa::Preparation::halfspaces); return true;
      case ExtremesSource::from_row: add(&isa::Preparation::values, values_of_row); return true;
      case ExtremesSource::known: break;
    }
    return false;
  }

 private:
  isa::Preparation* into_ = nullptr;
  Tested* tested_ = nullptr;
};

/// Testing a quadric over a rectangle evaluates three functions, each at its corners and its turning points.
inline constexpr std::uint64_t tests_of_quadric = 4;

}  // namespace csgsim::csg
