// Decides whether the stated rounding bounds explain a pixel.
// Used by sim/session and sim/studies.
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

/// Determines what a machine may draw at a pixel if the error of every plane is within the bounds stated by the design
/// (docs/numbers.md), at dx columns and dy rows from the middle of the picture, with f fraction bits and n bits of
/// depth:
///
/// - A plane is F = floor(z + e), |e| <= (1 + dx + dy) 2^-(f+1) steps, plus the rounding of doubles in computing z,
/// 2^-49 of the sum of its terms times SightPlane::condition. Half-spaces on the same plane have the same F.
/// - A plane steeper than 2^n steps in `edge_on_fraction` of a pixel contains or excludes the whole ray. If all depths
/// from near to far are on one side, more than (1 + dx + dy) 2^-(f+9) pixels from the plane, that side decides.
/// Otherwise both results are allowed, but only the same one for all half-spaces on the plane.
/// - A primitive is absent outside the rectangle of its vertices in the picture (including those of the near plane's
/// cuts), enlarged by a 64th and `edge_on_fraction` of a pixel. On the border it may be present or not.
/// - A quadric has the depths of host/view/screen_quadric.h, with the errors stated by QuadricBounds.
///
/// A picture is explained at a pixel if some such planes and quadrics produce it. Three-valued logic decides this. It
/// may explain slightly too many pixels where several planes are uncertain together, but never too few.
class Explainer {
 public:
  /// Keeps references to the tree and the geometry. The Program defines size, depth scale and accuracy.
  Explainer(const model::Tree& tree, const facet::Geometry& geometry, const view::Camera& camera,
            const isa::Program& program);

  /// Keeps references to the tree, the geometry and `sight`, which must be of that geometry, of the Program's size and
  /// with its depth scale.
  Explainer(const model::Tree& tree, const facet::Geometry& geometry, const Sight& sight, const isa::Program& program);

  /// Whether the machine may show that primitive (or `nothing`) at that depth step at the pixel.
  [[nodiscard]] bool may_show(std::uint32_t column, std::uint32_t row, std::uint32_t owner, std::uint32_t depth) const;

  /// Range of depth steps of a canonical plane, or a root of a canonical quadric, at the place. Indices as in Truth.
  [[nodiscard]] Steps steps(std::uint32_t surface, Place place) const;

 private:
  Explainer(const model::Tree& tree, const facet::Geometry& geometry, std::unique_ptr<const Sight> sight,
            const isa::Program& program);

  struct PossibleResults;
  [[nodiscard]] PossibleResults possible_results(std::uint32_t plane, Place place) const;
  [[nodiscard]] bool try_add_halfspace(Candidate& candidate, const facet::Halfspace& halfspace, Place place) const;
  [[nodiscard]] bool try_add_quadric(Candidate& candidate, const facet::QuadricSide& side, Place place) const;
  [[nodiscard]] Maybe is_in_rectangle(std::uint32_t primitive, Place place) const;
  [[nodiscard]] Ray make_ray(Place place) const;

  const model::Tree& tree_;
  const facet::Geometry& geometry_;
  std::uint32_t width_;
  std::uint32_t height_;
  std::unique_ptr<const Sight> own_sight_;  ///< null if the caller passed a sight
  const Sight& sight_;
  DepthLine line_;
  QuadricBounds quadrics_;
  std::vector<PlaceRect> reaches_;  ///< one per solid
  double steepest_;                 ///< depth steps per pixel
};

}  // namespace csgsim::judges
