#include "host/swept/curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <glm/common.hpp>

namespace csgsim::swept {

namespace {

constexpr std::uint32_t max_degree = 3;

std::size_t count_spans(const Curve& curve) {
  return curve.closed ? curve.points.size() : curve.points.size() - curve.degree;
}

/// Knot i; span k starts at knot k. The knots of an open curve before the first span or after the last span are clamped
/// to its ends.
double knot(const Curve& curve, std::ptrdiff_t i) {
  const auto spans = static_cast<double>(count_spans(curve));
  const auto place = static_cast<double>(i);
  return curve.closed ? place : std::clamp(place, 0.0, spans);
}

/// The polar form of span k at the given arguments, one per degree (de Boor's recurrence with a different argument in
/// each round).
glm::dvec3 blossom(const Curve& curve, std::size_t span, const std::array<double, 3>& arguments) {
  const auto k = static_cast<std::ptrdiff_t>(span);
  const auto p = static_cast<std::ptrdiff_t>(curve.degree);
  std::array<glm::dvec3, 4> points{};
  for (std::size_t i = 0; i <= curve.degree; ++i) points[i] = curve.points[(span + i) % curve.points.size()];
  for (std::ptrdiff_t round = 1; round <= p; ++round) {
    for (std::ptrdiff_t i = p; i >= round; --i) {
      const double low = knot(curve, k + i - p);
      const double high = knot(curve, k + i - round + 1);
      const double part = (arguments[static_cast<std::size_t>(round - 1)] - low) / (high - low);
      const auto to = static_cast<std::size_t>(i);
      points[to] = glm::mix(points[to - 1], points[to], part);
    }
  }
  return points[curve.degree];
}

}  // namespace

std::string validation_error(const Curve& curve) {
  const std::size_t points = curve.points.size();
  if (curve.degree > max_degree)
    return fmt::format("degree {} is above {}; use 0 (constant), 1, 2 or 3", curve.degree, max_degree);
  if (curve.degree == 0 && points != 1)
    return fmt::format("a constant, of degree 0, has one point, not {}; use degree 1", points);
  const std::size_t fewest = curve.closed ? std::max<std::size_t>(3, curve.degree + 1) : curve.degree + 1;
  if (points < fewest)
    return fmt::format("{} curve of degree {} needs at least {} points, not {}", curve.closed ? "a closed" : "an open",
                       curve.degree, fewest, points);
  if (points > max_curve_points)
    return fmt::format("a curve of {} points has more than {}; remove points", points, max_curve_points);
  return "";
}

std::vector<Segment> bernstein_segments(const Curve& curve) {
  const std::size_t spans = curve.degree == 0 ? 1 : count_spans(curve);
  std::vector<Segment> segments(spans);
  for (std::size_t k = 0; k < spans; ++k) {
    Segment& segment = segments[k];
    segment.degree = curve.degree;
    for (std::size_t i = 0; i <= curve.degree; ++i) {
      std::array<double, 3> arguments{};
      for (std::size_t j = 0; j < curve.degree; ++j)
        arguments[j] = static_cast<double>(k) + (j < curve.degree - i ? 0.0 : 1.0);
      segment.coefficients[i] = blossom(curve, k, arguments);
    }
    if (k > 0) segment.coefficients.front() = segments[k - 1].last();
  }
  if (curve.closed) segments.back().coefficients[curve.degree] = segments.front().first();
  return segments;
}

glm::dvec3 at(const Segment& segment, double t) {
  std::array<glm::dvec3, 4> points = segment.coefficients;
  for (std::uint32_t round = segment.degree; round > 0; --round) {
    for (std::uint32_t i = 0; i < round; ++i) points[i] = glm::mix(points[i], points[i + 1], t);
  }
  return points.front();
}

glm::dvec3 slope(const Segment& segment, double t) {
  if (segment.degree == 0) return glm::dvec3(0);
  Segment differences;
  differences.degree = segment.degree - 1;
  for (std::uint32_t i = 0; i < segment.degree; ++i)
    differences.coefficients[i] =
        static_cast<double>(segment.degree) * (segment.coefficients[i + 1] - segment.coefficients[i]);
  return at(differences, t);
}

std::array<Segment, 2> halves(const Segment& segment) {
  std::array<Segment, 2> parts{segment, segment};
  std::array<glm::dvec3, 4> points = segment.coefficients;
  for (std::uint32_t round = 0; round <= segment.degree; ++round) {
    const std::uint32_t last = segment.degree - round;
    parts[0].coefficients[round] = points[0];
    parts[1].coefficients[last] = points[last];
    for (std::uint32_t i = 0; i < last; ++i) points[i] = 0.5 * (points[i] + points[i + 1]);
  }
  return parts;
}

}  // namespace csgsim::swept
