#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "host/view/projection.h"
#include "sim/judges/truth.h"
#include "sim/observe/frame.h"
#include "tests/support/drawing.h"

namespace csgsim::testing {

using view::Projection;

/// A picture of odd size: its middle is a pixel centre.
inline view::Sampling odd_picture() {
  view::Sampling sampling;
  sampling.width = 127;
  sampling.height = 95;
  return sampling;
}

/// The parameters with which a hard case is drawn.
struct Look {
  view::Sampling sampling = odd_picture();
  std::uint32_t memory_bits = 96;
  bool engines = true;  ///< also compare all engines in a picture of 24 x 20
};

/// Sums over pictures.
struct Verdict {
  std::uint64_t pictures = 0;
  std::uint64_t covered = 0;  ///< pixels that the exact oracle covers
  std::uint64_t wrong = 0;    ///< wrong pixels, all of them explained by the stated bounds
  /// Wrong pixels where faces and edges pass pixel centres within rounding errors of doubles.
  std::uint64_t by_a_hair = 0;

  Verdict& operator+=(const Verdict& other);
};

/// Draws a model and compares it with the exact oracle; fails the test for a wrong pixel that no bound explains, and
/// where the functional, reference and cycle engines differ in a bit.
Verdict look(const std::string& csg, const view::Camera& camera, const Look& how = {});

/// Draws the model unchanged and turned by a right angle, by arbitrary angles and by 1e-7; from an oblique direction
/// and along an axis (faces edge-on); in both projections; filling the picture. 16 pictures. Wrong pixels of a turned
/// model seen along an axis count as `by_a_hair`: the middle of a symmetric model is then at the middle of the picture
/// up to rounding.
Verdict look_around(const std::string& csg, const Look& how = {});

/// Draws only the 8 oblique pictures, in which nothing lines up with pixel centres.
Verdict look_obliquely(const std::string& csg, const Look& how = {});

/// The exact oracle's picture of the unchanged model.
judges::Truth truth_of(const Compiled& compiled);

/// The picture of the functional engine.
observe::Frame picture_of(const std::string& csg, const view::Camera& camera, const Look& how = {});

/// A camera that sees the whole model from that direction.
view::Camera whole(const std::string& csg, const glm::dvec3& direction, Projection projection);

/// Whether both pictures have the same depth everywhere, and so show the same geometry.
bool same_depths(const observe::Frame& a, const observe::Frame& b);

/// Number of pixels at which anything is visible.
std::uint64_t covered_pixels(const observe::Frame& frame, unsigned z_bits);

}  // namespace csgsim::testing
