// Error counts of a picture compared with the true one.
// Used by sim/session and sim/studies.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "hw/isa/program.h"
#include "sim/observe/frame.h"

namespace csgsim::judges {

class Explainer;
struct Truth;

/// Error of depths at pixels with the right owner.
struct DepthError {
  double max = 0;
  double p999 = 0;  ///< bound for 99.9 % of those pixels
};

struct PixelPlace {
  std::uint32_t column = 0;
  std::uint32_t row = 0;
};

/// Errors of a picture. Counts are numbers of pixels.
struct Errors {
  std::uint64_t pixels = 0;
  std::uint64_t covered = 0;     ///< covered in the true picture
  std::uint64_t silhouette = 0;  ///< covered in only one of the pictures
  std::uint64_t owner = 0;       ///< covered in both, but by different primitives
  std::uint64_t depth = 0;       ///< right owner, but a depth step outside the rounding bounds of its plane (only from
                                 ///< judge())
  std::uint64_t explained = 0;   ///< wrong pixels that the stated bounds allow (only from judge())
  std::uint64_t unexplained = 0;
  std::optional<PixelPlace> first_unexplained;

  DepthError model_units;  ///< distance of the depth step (its near end) minus the true distance
  DepthError steps;        ///< that difference in depth steps: rounding down alone causes up to 1

  /// Number of wrong pixels.
  [[nodiscard]] std::uint64_t wrong() const { return silhouette + owner + depth; }
};

/// Counts wrong pixels and measures depth errors. The Program defines the frame's depth steps; frame and truth must
/// have the same size.
Errors compare(const Truth& truth, const observe::Frame& frame, const isa::Program& program);

/// As compare(), and determines whether the bounds stated by the design explain each wrong pixel. `truth` must be from
/// exact_truth() for the tree, geometry and camera of the explainer.
Errors judge(const Truth& truth, const observe::Frame& frame, const isa::Program& program, const Explainer& explainer);

/// A summary in one line.
std::string to_text(const Errors& errors);

}  // namespace csgsim::judges
