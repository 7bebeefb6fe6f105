// Planes between pairs of primitives, the same for every camera.
// Used by pruning, products and drawings.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>

#include "host/csg/counted.h"
#include "host/csg/hull.h"
#include "host/csg/prices.h"
#include "host/csg/separation.h"
#include "host/facet/geometry.h"
#include "host/view/projection.h"
#include "hw/isa/host_counts.h"

namespace csgsim::csg {

/// Searches planes between the corners of primitives in model space. Each pair is searched once, when it is first
/// needed, and the result holds for every camera. A table may serve several frames, and a frame may compile several
/// Programs until one fits. Keeps a reference to the geometry and is not thread-safe.
class PairTable {
 public:
  explicit PairTable(const facet::Geometry& geometry) : geometry_(geometry) {}

  /// Begins another frame.
  void begin_frame();
  [[nodiscard]] bool is_in_first_frame() const { return is_in_first_frame_; }

  /// Begins another Program: from now on price() returns the estimate of a new table, so that earlier frames do not
  /// change decisions.
  void begin_program() { ++program_; }

  /// Whether the pair's plane still separates the primitives in a view, where rounding moves their surfaces. `counted`
  /// counts the view's part of the work.
  [[nodiscard]] bool are_apart(std::uint32_t first, std::uint32_t second, const view::View& view,
                               const Counted& counted);

  /// Estimated nanoseconds of are_apart(); searches for earlier Programs do not lower the estimate.
  [[nodiscard]] double price(std::uint32_t first, std::uint32_t second, const Prices& prices) const;

  /// The work of this frame's searches.
  [[nodiscard]] const isa::Preparation& work() const { return work_; }

 private:
  struct Result {
    std::optional<Gap> gap;
    std::uint64_t program = 0;  ///< the last Program that needed the pair
  };
  Hull& hull(std::uint32_t primitive);

  const facet::Geometry& geometry_;
  std::unordered_map<std::uint32_t, Hull> hulls_;
  std::unordered_map<std::uint64_t, Result> results_;  ///< by pair, the lower number first
  isa::Preparation work_;
  std::uint64_t program_ = 0;
  bool is_in_first_frame_ = true;
};

}  // namespace csgsim::csg
