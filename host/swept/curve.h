#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace csgsim::swept {

/// A design curve: a B-spline of degree 0 (one constant) to 3, with uniform knots. An open one begins at its first
/// point and ends at its last one (clamped); a closed one is periodic. Curves in a plane or along a line leave the
/// other coordinates 0.
struct Curve {
  std::uint32_t degree = 1;
  bool closed = false;
  std::vector<glm::dvec3> points;
};

/// A polynomial piece of a curve in the form of Bernstein: degree + 1 coefficients, of which the first and the last are
/// its ends.
struct Segment {
  std::uint32_t degree = 0;
  std::array<glm::dvec3, 4> coefficients{};

  [[nodiscard]] const glm::dvec3& first() const { return coefficients.front(); }
  [[nodiscard]] const glm::dvec3& last() const { return coefficients[degree]; }
};

inline constexpr std::size_t most_curve_points = 10'000;

/// What is wrong with a curve, and what to do; empty if nothing is.
std::string fault_of(const Curve& curve);

/// A piece for each span between knots, in order; the end of one is the start of the next in the same numbers, and that
/// of a closed curve's last its first's. The curve has to be without fault.
std::vector<Segment> segments_of(const Curve& curve);

/// At t from 0 to 1.
glm::dvec3 at(const Segment& segment, double t);

/// The derivative by t.
glm::dvec3 slope(const Segment& segment, double t);

/// The halves from 0 to 1/2 and from there to 1 (Catmull 1974, de Casteljau). They meet in the same numbers.
std::array<Segment, 2> halves(const Segment& segment);

}  // namespace csgsim::swept
