// Coordinates for CGAL's exact arithmetic.
// Used by host/solids and host/flat.
#pragma once

namespace csgsim::model {

/// Minimum magnitude of a coordinate passed to CGAL; smaller coordinates, and -0, become 0. CGAL 5.5 converts a double
/// to a fraction by doubling it until it is an integer; below 2^-1023 the denominator would be infinite.
inline constexpr double min_exact_coordinate = 0x1p-500;

constexpr double exact_coordinate(double coordinate) {
  return coordinate < min_exact_coordinate && coordinate > -min_exact_coordinate ? 0.0 : coordinate;
}

/// A CGAL point with two or three coordinates.
template <typename Point, typename... Coordinates>
Point exact_point(Coordinates... coordinates) {
  return Point(exact_coordinate(coordinates)...);
}

}  // namespace csgsim::model
