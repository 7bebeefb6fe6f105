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

/// What is known of a tree before it is evaluated.
enum class Pruning : std::uint8_t {
  none,
  cells,   ///< a tree for each cell of 16 x 16 pixels, of the primitives that have pixels there (thesis 4.2, fig. 4.4)
  inside,  ///< while a ray is in a primitive, the tree of those that meet it (thesis 4.2, fig. 4.3)
};

/// What a method is given.
struct Subject {
  const model::Tree& model;
  const facet::Geometry& geometry;
  const view::View& view;
  const Tree& tree;  ///< of the model, in some shape
  Pruning pruning = Pruning::none;

  /// 2^n - 1, where nothing is seen.
  [[nodiscard]] std::uint32_t farthest() const { return (std::uint32_t{1} << view.sampling.z_bits) - 1; }
};

/// A method at work on a picture, whose bands come from the top.
class Method {
 public:
  Method() = default;
  virtual ~Method() = default;
  Method(const Method&) = delete;
  Method& operator=(const Method&) = delete;

  /// What is seen at the pixels of a band, row by row.
  virtual void classify(const RayBand& band, std::span<Seen> seen) = 0;
  /// Nothing but words, unless it was made to count.
  [[nodiscard]] virtual Counts counts() const = 0;
};

}  // namespace csgsim::software
