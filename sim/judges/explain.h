#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/camera.h"
#include "hw/isa/program.h"
#include "sim/judges/possible.h"
#include "sim/judges/quadric_bounds.h"
#include "sim/judges/quadric_reach.h"
#include "sim/judges/sight.h"

namespace csgsim::judges {

/// Says what a machine may draw at a pixel if every plane is off by no more than the design states (docs/numbers.md),
/// dx columns and dy rows from the middle of the picture, with f fraction bits and n bits of depth:
///
/// - A plane is F = floor(z + e), |e| <= (1 + dx + dy) 2^-(f+1) steps, plus the rounding of doubles on the way to z,
///   2^-49 of the sum of its terms times SightPlane::condition. Half-spaces on the same plane have the same F.
/// - A plane steeper than 2^n steps in `edge_on_fraction` of a pixel holds or does not hold the whole ray, by the true
///   side of it if all depths from near to far are on that side, more than (1 + dx + dy) 2^-(f+9) pixels from the
///   plane; else either, but the same for all half-spaces on the plane.
/// - A primitive is nowhere outside the rectangle of its vertices in the picture, those of the near plane's cuts among
///   them, with a 64th and `edge_on_fraction` of a pixel around it. On the border of that it may be or not.
/// - A quadric has the depths of host/view/screen_quadric.h, as far off as QuadricBounds says.
///
/// A picture is explained at a pixel if some such planes and quadrics make it. That is decided by three-valued logic,
/// which may allow a little too much where several planes are uncertain together, never too little.
class Explainer {
 public:
  /// Keeps references to the tree and the geometry. The Program tells size, depth scale and accuracy.
  Explainer(const model::Tree& tree, const facet::Geometry& geometry, const view::Camera& camera,
            const isa::Program& program);

  /// The same, of how that geometry is seen, in the Program's size and with its depth scale; kept by reference too.
  Explainer(const model::Tree& tree, const facet::Geometry& geometry, const Sight& sight, const isa::Program& program);

  /// Whether the machine may show that primitive (or `nothing`) at that depth step at the pixel.
  [[nodiscard]] bool may_show(std::uint32_t column, std::uint32_t row, std::uint32_t owner, std::uint32_t depth) const;

  /// Depth steps that a canonical plane, or a root of a canonical quadric, may have there. By its index in a Truth.
  [[nodiscard]] Steps steps(std::uint32_t surface, Place place) const;

 private:
  Explainer(const model::Tree& tree, const facet::Geometry& geometry, std::unique_ptr<const Sight> sight,
            const isa::Program& program);

  struct Nature;
  [[nodiscard]] Nature nature(std::uint32_t plane, Place place) const;
  [[nodiscard]] bool add_halfspace(Chance& chance, const facet::Halfspace& halfspace, Place place) const;
  [[nodiscard]] bool add_quadric(Chance& chance, const facet::QuadricSide& side, Place place) const;
  [[nodiscard]] Maybe in_rectangle(std::uint32_t primitive, Place place) const;
  [[nodiscard]] Ray make_ray(Place place) const;

  const model::Tree& tree_;
  const facet::Geometry& geometry_;
  std::uint32_t width_;
  std::uint32_t height_;
  std::unique_ptr<const Sight> own_sight_;  ///< where none was given
  const Sight& sight_;
  DepthLine line_;
  QuadricBounds quadrics_;
  std::vector<PlaceRect> reaches_;  ///< one a solid
  double steepest_;                 ///< depth steps a pixel
};

}  // namespace csgsim::judges
