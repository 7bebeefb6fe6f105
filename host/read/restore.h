#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <optional>

#include "host/model/tree.h"

namespace csgsim::read {

/// Whether all that the matrix turns, mirrors and swaps are whole axes, so that six digits lost nothing of its
/// rotation.
bool is_along_axes(const glm::dmat4& matrix);

/// The matrix before OpenSCAD wrote it with six significant digits, if its linear part is known: R, R S or S R, R a
/// rotation by Euler angles in steps of 0.01 degrees, S a scaling along the axes by numbers of three significant
/// digits, which mirrors if one is negative. Known is what has the same six digits in every entry: none moves by more
/// than half a unit of its sixth digit. The entries of R are right to 7e-16, and those of the product to 1e-15 times
/// the greatest factor of S, as that factor and the product are rounded once each. The column of the translation stays
/// as written.
std::optional<glm::dmat4> restored(const glm::dmat4& written);

/// Counts the matrices of a file that are not along the axes.
struct RestoredCount {
  std::uint32_t restored = 0;
  std::uint32_t as_written = 0;
  model::Location first_as_written;  ///< if there is one
};

}  // namespace csgsim::read
