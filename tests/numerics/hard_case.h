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

/// An odd size: the middle of the picture is a pixel centre.
inline view::Sampling odd_picture() {
  view::Sampling sampling;
  sampling.width = 127;
  sampling.height = 95;
  return sampling;
}

/// How a hard case is drawn.
struct Look {
  view::Sampling sampling = odd_picture();
  std::uint32_t memory_bits = 96;
  bool engines = true;  ///< hold all engines against each other, in a picture of 24 x 20
};

/// Sums over pictures.
struct Verdict {
  std::uint64_t pictures = 0;
  std::uint64_t covered = 0;  ///< pixels, in truth
  std::uint64_t wrong = 0;    ///< pixels, all of them explained by the stated bounds
  /// The same, where faces and edges pass pixel centres by the last bits of doubles, and may fall on either side.
  std::uint64_t by_a_hair = 0;

  Verdict& operator+=(const Verdict& other);
};

/// Draws a model and judges it by the exact oracle; fails the test for a wrong pixel that no bound explains, and where
/// functional, reference and cycle engine differ in a bit.
Verdict look(const std::string& csg, const view::Camera& camera, const Look& how = {});

/// The model as it is and turned by a right angle, by arbitrary angles and by a hair; from an oblique direction and
/// along an axis (faces edge-on); in both projections; filling the picture. 16 pictures. What is wrong
/// where the model is seen along an axis and turned is counted as a matter of hairs: the middle of a symmetric model is
/// at the middle of the picture then, up to rounding.
Verdict look_around(const std::string& csg, const Look& how = {});

/// The same from the oblique direction only: 8 pictures, in which nothing lines up with pixel centres.
Verdict look_obliquely(const std::string& csg, const Look& how = {});

/// The truth of one picture, of the model as it is.
judges::Truth truth_of(const Compiled& compiled);

/// The picture of the functional engine.
observe::Frame picture_of(const std::string& csg, const view::Camera& camera, const Look& how = {});

/// A camera that sees the whole model from that direction.
view::Camera whole(const std::string& csg, const glm::dvec3& direction, Projection projection);

/// Both pictures have the same depth everywhere: the same geometry.
bool same_depths(const observe::Frame& a, const observe::Frame& b);

/// Pixels at which anything is seen.
std::uint64_t covered_pixels(const observe::Frame& frame, unsigned z_bits);

}  // namespace csgsim::testing
