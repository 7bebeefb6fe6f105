// The true picture of a model, for judging machines.
// Used by sim/session and sim/studies.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/camera.h"
#include "hw/isa/depth_scale.h"
#include "hw/isa/program.h"

namespace csgsim::judges {

class Sight;

inline constexpr std::uint32_t nothing = 0xffffffffU;

/// The visible surfaces at the pixel centres of a picture, in row order from the top left.
struct Truth {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  /// Distance from the eye along the view axis, model units; infinite for the background.
  std::vector<double> distance;
  std::vector<std::uint32_t> owner;  ///< primitive, or `nothing`
  /// The visible surface: the index of a canonical plane; n, the number of planes, for the near cap; n + 1 + 2 i for
  /// the nearer root of canonical quadric i, and one more for the farther root (host/view/screen_quadric.h: `near` and
  /// `far`); or `nothing`. Empty in an analytic truth, which has no planes.
  std::vector<std::uint32_t> plane;
};

/// A picture of only background.
inline Truth empty_truth(std::uint32_t width, std::uint32_t height) {
  const std::size_t pixels = static_cast<std::size_t>(width) * height;
  return {width, height, std::vector<double>(pixels, std::numeric_limits<double>::infinity()),
          std::vector<std::uint32_t>(pixels, nothing), std::vector<std::uint32_t>(pixels, nothing)};
}

/// The picture of the model's half-spaces and quadrics by the rules of docs/numbers.md (half-open, ties, owner) and
/// docs/algorithm.md (view), in exact arithmetic (sight.h).
///
/// - A primitive fills [front, back) along the ray of a pixel centre: its front is its farthest plane that faces the
/// eye, its back the nearest plane that faces away. In perspective it begins at the near plane, depth.near, or later.
/// - Its quadrics bound it in the same way (quadric_sight.h): a ray exactly on an outline is outside; one in the
/// surface of a cylinder seen along its axis, or of a cone seen from its apex, is inside.
/// - The visible depth is the first behind which the point is in the tree of the model.
/// - Its owner is the first primitive in tree order whose front (back, if subtracted) is exactly at that depth and
/// whose surface no operator removes.
/// - Rays in a plane seen edge-on are moved infinitesimally to the right, and infinitesimally less downwards.
///
/// Doubles with a rigorous bound decide most comparisons; exact numbers decide the rest, with square roots by squaring
/// (surd.h), so that no bit depends on rounding. It takes about 0.1 s for 512 x 512 pixels with a few thousand
/// half-spaces. Only the near plane of `depth` is used.
Truth exact_truth(const model::Tree& tree, const facet::Geometry& geometry, const view::Camera& camera,
                  std::uint32_t width, std::uint32_t height, const isa::DepthScale& depth);

/// exact_truth() for the camera, the size and the depth scale of `sight`, which must be of that geometry.
Truth exact_truth(const model::Tree& tree, const facet::Geometry& geometry, const Sight& sight);

}  // namespace csgsim::judges
