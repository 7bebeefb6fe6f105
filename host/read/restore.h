// Recovery of rotations from six printed digits.
// Used by build.h.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <optional>

#include "host/model/tree.h"

namespace csgsim::read {

/// Whether the linear part only rotates by right angles, mirrors, swaps axes or scales, so that six digits represent
/// its rotation exactly.
bool is_along_axes(const glm::dmat4& matrix);

/// Recovers a matrix that OpenSCAD wrote with six significant digits, if its linear part is R, R S or S R, where R is a
/// rotation by Euler angles in steps of 0.01 degrees, and S scales along the axes by numbers with three significant
/// digits, which may be negative to mirror. The recovered matrix must have the same six digits in every entry, so no
/// entry changes by more than half a unit of its sixth digit. The entries of R are accurate to 7e-16, and those of the
/// product to 1e-15 times the largest factor of S, since the factor and the product are rounded once each. The
/// translation column stays as written. Empty if no such matrix is found.
std::optional<glm::dmat4> restored(const glm::dmat4& written);

/// Counts of a file's matrices with and without a restored rotation; matrices along the axes are not counted.
struct RestoredCount {
  std::uint32_t restored = 0;
  std::uint32_t as_written = 0;
  model::Location first_as_written;  ///< position of the first matrix that was not restored, if any
};

}  // namespace csgsim::read
