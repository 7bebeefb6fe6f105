#pragma once

namespace csgsim::model {

/// A coordinate as CGAL's exact arithmetic takes it: whatever is nearer to 0 than this, and -0, becomes 0. CGAL 5.5
/// makes a fraction of a double by doubling it until it is whole, and the denominator of one below 2^-1023 is infinite.
inline constexpr double least_exact_coordinate = 0x1p-500;

constexpr double exact_coordinate(double coordinate) {
  return coordinate < least_exact_coordinate && coordinate > -least_exact_coordinate ? 0.0 : coordinate;
}

/// CGAL's point of two or three coordinates.
template <typename Point, typename... Coordinates>
Point exact_point(Coordinates... coordinates) {
  return Point(exact_coordinate(coordinates)...);
}

}  // namespace csgsim::model
