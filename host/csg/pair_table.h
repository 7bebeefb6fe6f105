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
/// needed, and the result holds for every camera. Keeps a reference to the geometry and is not thread-safe.
class PairTable {
 public:
  explicit PairTable(const facet::Geometry& geometry) : geometry_(geometry) {}

  /// Whether the pair's plane still separates the primitives in a view, where rounding moves their surfaces. `counted`
  /// counts the view's part of the work.
  [[nodiscard]] bool are_apart(std::uint32_t one, std::uint32_t other, const view::View& view, const Counted& counted);

  /// Estimated nanoseconds of are_apart().
  [[nodiscard]] double price(std::uint32_t one, std::uint32_t other, const Prices& prices) const;

  /// The work of all searches until now.
  [[nodiscard]] const isa::Preparation& work() const { return work_; }

 private:
  Hull& hull(std::uint32_t primitive);

  const facet::Geometry& geometry_;
  std::unordered_map<std::uint32_t, Hull> hulls_;
  std::unordered_map<std::uint64_t, std::optional<Gap>> gaps_;  ///< by pair, the lower number first
  isa::Preparation work_;
};

}  // namespace csgsim::csg
