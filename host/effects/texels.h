// Texture coordinates of flat facets, and the lines between texels.
// Used by textures.cpp and tests.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "host/emit/context.h"
#include "host/emit/halfspaces.h"
#include "host/view/fixed_point.h"

namespace csgsim::effects {

/// The position of texels in model space.
struct TexelGrid {
  double size = 1;       ///< side of a texel, model units
  glm::dvec2 corner{0};  ///< start of column 0 and row 0, model units along u and v
};

/// A texture coordinate of a flat facet in texels, as a function of the pixel: numerator / denominator. The denominator
/// is positive where the facet is visible, and constant 1 in an orthographic view.
struct TexelCoordinate {
  view::RealLinear numerator;
  view::RealLinear denominator;
  double least = 0;  ///< minimum over the whole facet, in texels
  double most = 0;
};

/// Both coordinates of a facet's texels.
struct TexelCoordinates {
  TexelCoordinate u;
  TexelCoordinate v;
};

/// u and v are the two model axes most nearly parallel to the facet, in the order x, y, z: the axis of the normal's
/// greatest component is omitted, the first of these if several are equal.
TexelCoordinates texel_coordinates(const emit::Context& context, const emit::Facet& facet, const TexelGrid& grid);

/// Bound of the displacement of a texel's boundary by rounding, in pixels.
inline constexpr double boundary_error = 1.0 / 32;

/// A line at which a coordinate passes an integer: the coordinate is at least that integer where Ax + By + C >= 0.
struct TexelLine {
  std::int64_t number = 0;
  /// Empty if no pixel of the picture is near the line.
  std::optional<view::FixedLinear> line;
  bool is_beyond = false;  ///< without a line: whether the coordinate is at least `number` at every pixel
};

/// The lines of a coordinate over a facet.
struct TexelLines {
  std::int64_t first = 0;  ///< integer part of the minimum
  std::vector<TexelLine> lines;
};

/// The lines of a coordinate over a facet; empty if the numbers do not fit.
std::optional<TexelLines> texel_lines(const TexelCoordinate& coordinate, const view::Sampling& sampling);

/// Number of lines of a coordinate.
double count_lines(const TexelCoordinate& coordinate);

/// An orthographic coordinate modulo 2^bits, as a fixed-point number with `fraction_bits` fraction bits.
struct PeriodicCoordinate {
  view::FixedLinear linear;
  unsigned fraction_bits = 0;
};

/// The coordinate in periodic form; empty if the coefficients do not fit.
std::optional<PeriodicCoordinate> periodic(const TexelCoordinate& coordinate, unsigned bits,
                                           const view::Sampling& sampling);

}  // namespace csgsim::effects
