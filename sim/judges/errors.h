#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "hw/isa/program.h"
#include "sim/observe/frame.h"

namespace csgsim::judges {

class Explainer;
struct Truth;

/// How far depths are off where the owner is right.
struct DepthError {
  double max = 0;
  double p999 = 0;  ///< at most this at 99.9 % of those pixels
};

struct PixelPlace {
  std::uint32_t column = 0;
  std::uint32_t row = 0;
};

/// How wrong a picture is. Counts are pixels.
struct Errors {
  std::uint64_t pixels = 0;
  std::uint64_t covered = 0;     ///< in the truth
  std::uint64_t silhouette = 0;  ///< something seen in one of the pictures only
  std::uint64_t owner = 0;       ///< covered in both, by different primitives
  std::uint64_t depth = 0;       ///< right owner, but a depth step beyond what rounding allows its plane (judge() only)
  std::uint64_t explained = 0;   ///< wrong pixels that the stated bounds allow (judge() only)
  std::uint64_t unexplained = 0;
  std::optional<PixelPlace> first_unexplained;

  DepthError model_units;  ///< distance of the depth step (its near end) against the true distance
  DepthError steps;        ///< the same in depth steps: floor alone makes up to 1

  [[nodiscard]] std::uint64_t wrong() const { return silhouette + owner + depth; }
};

/// Counts wrong pixels, and measures depth. The Program tells what the frame's depth steps stand for; sizes of frame
/// and truth have to agree.
Errors compare(const Truth& truth, const observe::Frame& frame, const isa::Program& program);

/// The same, and says whether the bounds that the design states explain each wrong pixel. `truth` has to be
/// exact_truth's, of the same tree, geometry and camera.
Errors judge(const Truth& truth, const observe::Frame& frame, const isa::Program& program, const Explainer& explainer);

/// One line for people.
std::string to_text(const Errors& errors);

}  // namespace csgsim::judges
