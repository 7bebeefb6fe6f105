// B-spline design curves and their Bernstein segments.
// Used by net.cpp, orientation.h, sweep.h and host/commands.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace csgsim::swept {

/// A design curve: a B-spline of degree 0 (a constant) to 3 with uniform knots. An open curve is clamped: it starts at
/// its first point and ends at its last point. A closed curve is periodic. In planar or one-dimensional curves the
/// other coordinates are 0.
struct Curve {
  std::uint32_t degree = 1;
  bool closed = false;
  std::vector<glm::dvec3> points;
};

/// A polynomial piece of a curve in Bernstein form: degree + 1 coefficients. The first and last coefficients are its
/// end points.
struct Segment {
  std::uint32_t degree = 0;
  std::array<glm::dvec3, 4> coefficients{};

  [[nodiscard]] const glm::dvec3& first() const { return coefficients.front(); }
  [[nodiscard]] const glm::dvec3& last() const { return coefficients[degree]; }
};

inline constexpr std::size_t max_curve_points = 10'000;

/// The error in a curve and how to fix it; empty if the curve is valid.
std::string validation_error(const Curve& curve);

/// One piece per knot span, in order. Adjacent pieces share their end point exactly, and so do the last and first piece
/// of a closed curve. The curve must be valid.
std::vector<Segment> bernstein_segments(const Curve& curve);

/// The point of a segment at the parameter t, from 0 to 1.
glm::dvec3 at(const Segment& segment, double t);

/// The derivative of a segment with respect to t.
glm::dvec3 slope(const Segment& segment, double t);

/// The halves [0, 1/2] and [1/2, 1] of a segment (Catmull 1974, de Casteljau). They share their end point exactly.
std::array<Segment, 2> halves(const Segment& segment);

}  // namespace csgsim::swept
