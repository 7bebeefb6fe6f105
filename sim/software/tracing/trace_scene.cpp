#include "sim/software/tracing/trace_scene.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <limits>
#include <span>

#include "sim/software/rays/span.h"

namespace csgsim::software {

namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

double distance_to_edge(const glm::dvec3& point, const glm::dvec3& from, const glm::dvec3& to) {
  const glm::dvec3 along = to - from;
  const double length = glm::dot(along, along);
  const double part = length > 0 ? std::clamp(glm::dot(point - from, along) / length, 0.0, 1.0) : 0.0;
  return glm::length(point - from - along * part);
}

/// Distance of a point to a convex polygon, which may be degenerate (an edge or a corner).
double distance_to(const glm::dvec3& point, std::span<const glm::dvec3> corners) {
  glm::dvec3 normal{0};
  for (std::size_t i = 2; i < corners.size(); ++i)
    normal += glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
  const double area = glm::length(normal);
  bool is_within = area > 0;
  double min_distance = endless;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3& from = corners[i];
    const glm::dvec3& to = corners[(i + 1) % corners.size()];
    min_distance = std::min(min_distance, distance_to_edge(point, from, to));
    is_within = is_within && glm::dot(glm::cross(normal, to - from), point - from) >= 0;
  }
  return is_within ? std::abs(glm::dot(normal, point - corners[0])) / area : min_distance;
}

}  // namespace

TraceScene::TraceScene(const model::Tree& model, const facet::Geometry& geometry, const view::View& view,
                       const Tree& tree)
    : geometry_(geometry),
      view_(view),
      tree_(tree),
      facets_(facets_of(model, geometry)),
      shapes_(facets_),
      screen_(screen_facets(model, geometry, view, facets_)),
      eye_(view::eye_space(view.camera, view.sampling)),
      screen_of_(facets_.facets.size(), none),
      loose_(view.sampling.height) {
  constexpr double rounding = 1e-9;
  slack_ = rounding * (shapes_.box().empty() ? 1.0 : shapes_.box().diagonal());
  begin_ = isa::distance_at(view.depth, view.sampling.z_bits, 0) - slack_;
  end_ = isa::distance_at(view.depth, view.sampling.z_bits, screen_.farthest) + slack_;
  if (!(end_ > begin_)) end_ = endless;  // depth extends to infinity
  for (std::uint32_t i = 0; i < screen_.facets.size(); ++i) {
    const ScreenFacet& facet = screen_.facets[i];
    if (!is_loose(facet)) {
      screen_of_[facet.facet] = i;
      continue;
    }
    ++loose_facets_;
    for (std::int32_t row = facet.pixels.y0; row <= facet.pixels.y1; ++row)
      loose_[static_cast<std::size_t>(row)].push_back(i);
  }
}

/// Tests only the ends of each row of pixels, because the distance is maximal there.
bool TraceScene::is_loose(const ScreenFacet& facet) const {
  if (facet.facet == ScreenFacet::near_cap) return true;
  const std::span<const glm::dvec3> corners = facets_.corners_of(facet.facet);
  if (corners.empty()) return true;
  const view::FixedLinear& depth = facet.depth;
  const std::int64_t farthest = std::int64_t{screen_.farthest} << screen_.fraction_bits;
  for (std::int32_t row = facet.pixels.y0; row <= facet.pixels.y1; ++row) {
    const std::int64_t begin = depth.b * row + depth.c;
    Span span = screen_.span_of(facet, row);
    const auto is_before = [&](std::int32_t column) { return value_at(depth, column, row) < 0; };
    if (!facet.leaves && !span.empty() && (is_before(span.first) || is_before(span.last))) return true;
    clip(span, depth.a, begin);
    clip(span, -depth.a, farthest - begin);
    if (!span.empty() && (is_far(facet, corners, span.first, row) || is_far(facet, corners, span.last, row)))
      return true;
  }
  return false;
}

bool TraceScene::is_far(const ScreenFacet& facet, std::span<const glm::dvec3> corners, std::int32_t column,
                        std::int32_t row) const {
  const double one = std::ldexp(1.0, static_cast<int>(screen_.fraction_bits));
  const auto value = static_cast<double>(value_at(facet.depth, column, row));
  const double distance = isa::distance_at(view_.depth, view_.sampling.z_bits, value / one);
  if (!std::isfinite(distance) || (eye_.perspective && distance <= 0)) return true;
  const glm::dvec3 place = eye_.to_model(eye_.from_picture({column, row, distance})) - geometry_.planes.centre();
  return !(distance_to(place, corners) <= shapes_.reach() / 2);
}

SpaceRay TraceScene::ray_of(std::int32_t column, std::int32_t row) const {
  const double from = eye_.perspective ? 1 : 0;
  const glm::dvec3 place = eye_.to_model(eye_.from_picture({column, row, from}));
  if (!eye_.perspective) return {place - geometry_.planes.centre(), eye_.axes.forward, begin_, end_};
  return {eye_.eye - geometry_.planes.centre(), place - eye_.eye, begin_, end_};
}

double TraceScene::depth_at(double t) const {
  if (t == endless) return endless;
  const double known = t - slack_;
  if (eye_.perspective && known <= 0) return 0;
  return isa::depth_of(view_.depth, view_.sampling.z_bits, known);
}

glm::dvec3 TraceScene::direction_of(const glm::dvec3& in_camera) const {
  return eye_.to_model(in_camera) - eye_.to_model({0, 0, 0});
}

glm::dvec3 TraceScene::place_of(const glm::dvec3& in_camera) const {
  return eye_.to_model(in_camera) - geometry_.planes.centre();
}

}  // namespace csgsim::software
