#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "host/emit/context.h"
#include "host/emit/halfspaces.h"
#include "host/view/fixed_point.h"

namespace csgsim::effects {

/// How texels lie in model space.
struct TexelGrid {
  double size = 1;       ///< of a texel's side, model units
  glm::dvec2 corner{0};  ///< where column 0 and row 0 begin, model units along u and v
};

/// A texture coordinate of a flat facet, counted in texels, over the picture: numerator / denominator. The denominator
/// is above 0 where the facet is seen, and 1 everywhere in an orthographic view.
struct TexelCoordinate {
  view::RealLinear numerator;
  view::RealLinear denominator;
  double least = 0;  ///< of the whole facet
  double most = 0;
};

/// Both coordinates. u and v are the two model axes that lie most nearly in the facet, in the order x, y, z: the axis
/// that its normal has most of is left out, the first of equals.
struct TexelCoordinates {
  TexelCoordinate u;
  TexelCoordinate v;
};

TexelCoordinates texel_coordinates(const emit::Context& context, const emit::Facet& facet, const TexelGrid& grid);

/// How far a boundary between texels may be drawn from where it is, pixels.
inline constexpr double boundary_error = 1.0 / 32;

/// A line on which a coordinate is a whole number: there it is not below that number where Ax + By + C >= 0.
struct TexelLine {
  std::int64_t number = 0;
  /// Nothing where no pixel of the picture is near the line.
  std::optional<view::FixedLinear> line;
  bool is_beyond = false;  ///< without a line: the coordinate is not below the number at any pixel
};

/// How a coordinate is counted over a facet.
struct TexelLines {
  std::int64_t first = 0;  ///< the whole part where it is least
  std::vector<TexelLine> lines;
};

/// Nothing where the numbers do not fit.
std::optional<TexelLines> lines_of(const TexelCoordinate& coordinate, const view::Sampling& sampling);

/// How many lines there are.
double count_lines(const TexelCoordinate& coordinate);

/// An orthographic coordinate modulo 2^bits as a number with `fraction_bits` fraction bits.
struct PeriodicCoordinate {
  view::FixedLinear linear;
  unsigned fraction_bits = 0;
};

/// Nothing where the coefficients do not fit.
std::optional<PeriodicCoordinate> periodic(const TexelCoordinate& coordinate, unsigned bits,
                                           const view::Sampling& sampling);

}  // namespace csgsim::effects
