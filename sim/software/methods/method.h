// Interface of classification methods.
// Implemented by the methods and used by draw.h.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/projection.h"
#include "sim/software/methods/counts.h"
#include "sim/software/rays/ray_band.h"
#include "sim/software/tree/tree.h"

namespace csgsim::software {

/// How trees are pruned in advance.
enum class Pruning : std::uint8_t {
  none,
  cells,   ///< one tree per cell of 16 x 16 pixels, with the primitives that have pixels in it (thesis 4.2, fig. 4.4)
  inside,  ///< while a ray is inside a primitive, the tree of the primitives that intersect it (thesis 4.2, fig. 4.3)
};

/// Inputs of a method.
struct Subject {
  const model::Tree& model;
  const facet::Geometry& geometry;
  const view::View& view;
  const Tree& tree;  ///< tree of the model, in some shape
  Pruning pruning = Pruning::none;

  /// 2^n - 1, the depth where nothing is visible.
  [[nodiscard]] std::uint32_t farthest() const { return (std::uint32_t{1} << view.sampling.z_bits) - 1; }
};

/// Classifies the rays of a picture, band by band from the top.
class Method {
 public:
  Method() = default;
  virtual ~Method() = default;
  Method(const Method&) = delete;
  Method& operator=(const Method&) = delete;

  /// Computes the visible surfaces of a band, row by row.
  virtual void classify(const RayBand& band, std::span<VisibleSurface> seen) = 0;
  /// Only `words` is set unless the method was created to count.
  [[nodiscard]] virtual Counts counts() const = 0;
};

}  // namespace csgsim::software
