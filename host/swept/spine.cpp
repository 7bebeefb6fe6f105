#include "host/swept/spine.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "hw/base/error.h"

namespace csgsim::swept {

namespace {

/// Nodes and weights of the five-point Gauss-Legendre quadrature on [-1, 1].
struct GaussPoint {
  double place;
  double weight;
};
constexpr std::array gauss_points{GaussPoint{-0.9061798459386640, 0.2369268850561891},
                                  GaussPoint{-0.5384693101056831, 0.4786286704993665},
                                  GaussPoint{0, 0.5688888888888889}, GaussPoint{0.5384693101056831, 0.4786286704993665},
                                  GaussPoint{0.9061798459386640, 0.2369268850561891}};

/// Length of a segment from its start to t.
double arc_length(const Segment& segment, double t) {
  if (segment.degree == 1) return t * glm::distance(segment.first(), segment.last());
  constexpr int parts = 16;
  const double half = 0.5 * t / parts;
  double length = 0;
  for (int i = 0; i < parts; ++i) {
    for (const auto [place, weight] : gauss_points)
      length += weight * half * glm::length(slope(segment, half * (2 * i + 1 + place)));
  }
  return length;
}

/// Value of a function at a position in [0, 1].
glm::dvec3 value(const std::vector<Segment>& function, double place) {
  const auto count = static_cast<double>(function.size());
  const double scaled = std::clamp(place, 0.0, 1.0) * count;
  const double segment = std::min(std::floor(scaled), count - 1);
  return at(function[static_cast<std::size_t>(segment)], scaled - segment);
}

Path make_path(const Curve& trajectory) {
  Path path{bernstein_segments(trajectory), trajectory.closed, trajectory.degree == 1};
  if (path.has_corners) return path;
  // The curve is smooth except where control points coincide. The sections on both sides of such a corner would differ.
  constexpr double corner = 1e-3;
  const std::size_t count = path.segments.size();
  for (std::size_t i = path.is_closed ? 0 : 1; i < count; ++i) {
    const glm::dvec3 in = path.arriving((i + count - 1) % count);
    if (glm::distance(in, path.leaving(i)) > corner)
      throw InputError(fmt::format(
          "the trajectory has a corner where its segment {} starts; move coincident points apart, or use degree 1",
          i + 1));
  }
  return path;
}

/// The axes of a plane, projected along a straight segment to a plane perpendicular to the segment.
Plane flattened(const Plane& plane, const glm::dvec3& along) {
  return {plane.u - glm::dot(plane.u, along) * along, plane.v - glm::dot(plane.v, along) * along};
}

/// The offset along a segment at which the plane is above a vector perpendicular to the segment.
double reach(const glm::dvec3& across, const Plane& plane, const glm::dvec3& along) {
  const glm::dvec3 normal = glm::cross(plane.u, plane.v);
  return -glm::dot(across, normal) / glm::dot(along, normal);
}

/// A plane inside a straight segment. It interpolates the rotation about the segment, and the tilt, between the planes
/// at the ends.
Plane between(const Plane& from, const Plane& to, const glm::dvec3& along, double t) {
  const Plane start = flattened(from, along);
  const Plane end = flattened(to, along);
  const double angle = t * std::atan2(glm::dot(end.v, -start.u), glm::dot(end.v, start.v));
  Plane plane{std::cos(angle) * start.u + std::sin(angle) * start.v,
              std::cos(angle) * start.v - std::sin(angle) * start.u};
  for (glm::dvec3* const axis : {&plane.u, &plane.v})
    *axis += glm::mix(reach(*axis, from, along), reach(*axis, to, along), t) * along;
  return plane;
}

void check_closing(const Section& first, const Section& last) {
  const double size = std::max(glm::length(first.u), glm::length(first.v));
  constexpr double nearly = 1e-9;
  if (glm::distance(first.u, last.u) > nearly * size || glm::distance(first.v, last.v) > nearly * size)
    throw InputError(
        "the contour does not match itself where the trajectory closes; change the rotation to a multiple of "
        "360 degrees in total, and end the scale at its initial value");
}

}  // namespace

Spine::Spine(const Sweep& sweep)
    : path_(make_path(sweep.trajectory)),
      orientation_(path_),
      rotation_(bernstein_segments(sweep.rotation)),
      scale_(bernstein_segments(sweep.scale)) {
  measure_lengths();
  const std::size_t count = path_.segments.size();
  for (std::size_t i = 0; i <= count; ++i) {
    planes_.push_back(joint_plane(path_.is_closed ? i % count : i));
    const Segment& segment = path_.segments[std::min(i, count - 1)];
    joints_.push_back(
        make_section(i < count ? segment.first() : segment.last(), planes_.back(), length_fraction(i, 0)));
  }
  if (!path_.is_closed) return;
  check_closing(joints_.front(), joints_.back());
  joints_.back() = joints_.front();
}

void Spine::measure_lengths() {
  lengths_.assign(1, 0);
  for (const Segment& segment : path_.segments) lengths_.push_back(lengths_.back() + arc_length(segment, 1));
}

double Spine::length_fraction(std::size_t segment, double t) const {
  const double there = t == 0 ? 0 : arc_length(path_.segments[segment], t);
  return (lengths_[segment] + there) / lengths_.back();
}

bool Spine::is_short(std::size_t segment, double from, double to) const {
  const bool is_even = rotation_.front().degree == 0 && scale_.front().degree == 0;
  if (is_even) return true;
  const double begin = length_fraction(segment, from);
  const double length = length_fraction(segment, to) - begin;
  const std::size_t pieces = std::max(rotation_.size(), scale_.size());
  if (pieces > 1 && length * static_cast<double>(pieces) > 1) return false;
  constexpr int steps = 8;
  constexpr double right_angle = 90;
  double turn = 0;
  for (int i = 0; i < steps; ++i)
    turn +=
        std::abs(value(rotation_, begin + length * (i + 1) / steps).x - value(rotation_, begin + length * i / steps).x);
  return turn <= right_angle;
}

Plane Spine::joint_plane(std::size_t number) const {
  const auto place = static_cast<double>(number);
  const glm::dvec3 tangent = path_.tangent(place);
  const glm::dvec3 v = orientation_.upward(place, tangent);
  Plane plane{glm::cross(v, tangent), v};
  const std::size_t count = path_.segments.size();
  if (!path_.has_corners || (!path_.is_closed && (number == 0 || number == count))) return plane;
  const glm::dvec3 out = path_.leaving(number);
  const glm::dvec3 bend = out - glm::dot(out, tangent) * tangent;
  const double sine = glm::length(bend);
  if (sine < 1e-12) return plane;
  const double longer = 1 / glm::dot(out, tangent) - 1;
  for (glm::dvec3* const axis : {&plane.u, &plane.v}) *axis += longer * glm::dot(*axis, bend / sine) * (bend / sine);
  return plane;
}

Section Spine::make_section(const glm::dvec3& origin, const Plane& plane, double fraction) const {
  const double angle = glm::radians(value(rotation_, fraction).x);
  const glm::dvec3 scale = value(scale_, fraction);
  return {origin, scale.x * (std::cos(angle) * plane.u + std::sin(angle) * plane.v),
          scale.y * (std::cos(angle) * plane.v - std::sin(angle) * plane.u)};
}

Section Spine::section(std::size_t segment, double t, const glm::dvec3& origin) const {
  const double part = length_fraction(segment, t);
  if (path_.has_corners)
    return make_section(origin, between(planes_[segment], planes_[segment + 1], path_.leaving(segment), t), part);
  const double place = static_cast<double>(segment) + t;
  const glm::dvec3 tangent = path_.tangent(place);
  const glm::dvec3 v = orientation_.upward(place, tangent);
  return make_section(origin, {glm::cross(v, tangent), v}, part);
}

}  // namespace csgsim::swept
