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

/// What is seen at the pixel centres of a picture, in row order from the top left.
struct Truth {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  /// From the eye along the view axis, model units; infinite where nothing is seen.
  std::vector<double> distance;
  std::vector<std::uint32_t> owner;  ///< primitive, or `nothing`
  /// What is seen: the index of a canonical plane; n, the number of planes, for the near cap; n + 1 + 2 i for the
  /// nearer root of canonical quadric i, and one more for the farther one (host/view/screen_quadric.h: `near` and
  /// `far`); or `nothing`. Empty in an analytic truth, which has no planes.
  std::vector<std::uint32_t> plane;
};

/// A picture of nothing.
inline Truth empty_truth(std::uint32_t width, std::uint32_t height) {
  const std::size_t pixels = static_cast<std::size_t>(width) * height;
  return {width, height, std::vector<double>(pixels, std::numeric_limits<double>::infinity()),
          std::vector<std::uint32_t>(pixels, nothing), std::vector<std::uint32_t>(pixels, nothing)};
}

/// The picture that the model's half-spaces and quadrics make by the rules of docs/numbers.md (half-open, ties, owner)
/// and of docs/algorithm.md (view), in exact arithmetic (sight.h).
///
/// - A primitive fills [front, back) along the ray of a pixel centre: front is its farthest plane that faces the eye,
///   back its nearest that faces away. In perspective it begins at the near plane, depth.near, at the earliest.
/// - Its quadrics bound it in the same way (quadric_sight.h): a ray on an outline exactly has nothing of it, one in the
///   surface of a cylinder seen along its axis, or of a cone from its apex, is in it.
/// - The depth seen is the first at which the tree, as the model states it, holds the point just behind.
/// - Its owner is the first primitive in tree order of those whose front (back, where the primitive is taken away) is
///   at that depth exactly and whose surface no operator takes away.
/// - Rays in a plane that is seen edge-on are moved right, and down by less, by less than anything.
///
/// Doubles with a rigorous bound decide most comparisons, exact numbers the rest, square roots by squaring (surd.h), so
/// no bit depends on rounding. Takes
/// some 0.1 s for 512 x 512 pixels of a few thousand half-spaces. `depth` is used for its near plane only.
Truth exact_truth(const model::Tree& tree, const facet::Geometry& geometry, const view::Camera& camera,
                  std::uint32_t width, std::uint32_t height, const isa::DepthScale& depth);

/// The same, as that geometry is seen.
Truth exact_truth(const model::Tree& tree, const facet::Geometry& geometry, const Sight& sight);

}  // namespace csgsim::judges
