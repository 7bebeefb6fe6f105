#include "host/solids/slice_count.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>

#include "host/model/fragments.h"
#include "hw/base/error.h"

namespace csgsim::solids {

namespace {

/// Maximum number of faces of an extrusion before it is cut into pieces.
constexpr std::size_t max_swept_faces = 4'000'000;

constexpr double degrees_a_slice = 120.0;  ///< maximum twist of one slice

/// The maximum over all corners of the area of a squared length.
template <class Squared>
double greatest(const flat::Area& area, const Squared& squared) {
  double most = 0;
  for (const flat::Outline& outline : area.outlines) {
    for (const glm::dvec2& corner : outline) most = std::max(most, squared(corner));
  }
  return most;
}

/// Length of the Archimedean spiral r = step * angle, from its start to `angle` in radians.
double spiral_length(double step, double angle) {
  return 0.5 * step * (angle * std::sqrt(1.0 + angle * angle) + std::asinh(angle));
}

/// Length of the path of a corner, given its squared distance from the axis. The corner turns by `turn` radians on its
/// way up.
double path_length(double squared_radius, double turn, const LinearExtrude& extrusion) {
  const double scale = extrusion.scale.x;
  if (scale == 1.0 || scale != extrusion.scale.y) {
    const double rise = extrusion.height / turn;
    return turn * std::sqrt(squared_radius + rise * rise);
  }
  const double last = scale > 1.0 ? turn * scale / (scale - 1.0) : turn / (1.0 - scale);
  const double step = std::sqrt(squared_radius) / last;
  const double flat = spiral_length(step, last) - spiral_length(step, last - turn);
  return std::sqrt(flat * flat + extrusion.height * extrusion.height);
}

double twisted_count(const flat::Area& area, const LinearExtrude& extrusion) {
  const double twist = std::abs(extrusion.twist);
  const double fewest = std::max(std::ceil(twist / degrees_a_slice), 1.0);
  const double squared_radius = greatest(area, [](const glm::dvec2& corner) { return glm::dot(corner, corner); });
  const model::FacetControl& facets = extrusion.facets;
  if (std::sqrt(squared_radius) < model::grid_fine || !std::isfinite(facets.fn)) return fewest;
  if (facets.fn > 0.0) return std::max(std::ceil(twist / 360.0 * facets.fn), fewest);
  const double turn = twist * std::numbers::pi / 180.0;
  const double by_length = std::ceil(path_length(squared_radius, turn, extrusion) / facets.fs);
  return std::max(std::min(std::ceil(twist / facets.fa), by_length), fewest);
}

double straight_count(const flat::Area& area, const LinearExtrude& extrusion) {
  const double squared_shift = greatest(area, [&](const glm::dvec2& corner) {
    const glm::dvec2 shift = corner - corner * extrusion.scale;
    return glm::dot(shift, shift);
  });
  const model::FacetControl& facets = extrusion.facets;
  if (std::sqrt(squared_shift) < model::grid_fine || !std::isfinite(facets.fn)) return 1.0;
  if (facets.fn > 0.0) return std::max(std::floor(facets.fn), 1.0);
  return std::max(std::ceil(std::sqrt(squared_shift + extrusion.height * extrusion.height) / facets.fs), 1.0);
}

std::size_t corner_count(const flat::Area& area) {
  std::size_t count = 0;
  for (const flat::Outline& outline : area.outlines) count += outline.size();
  return count;
}

}  // namespace

std::uint32_t slice_count(const flat::Area& area, const LinearExtrude& extrusion) {
  const double count = extrusion.slices != 0    ? extrusion.slices
                       : extrusion.twist != 0.0 ? twisted_count(area, extrusion)
                                                : straight_count(area, extrusion);
  const double most = static_cast<double>(max_swept_faces) / (2.0 * static_cast<double>(corner_count(area)));
  if (!(count <= most)) {
    throw InputError("linear_extrude() makes more than " + std::to_string(max_swept_faces) +
                     " faces; use fewer slices, or raise $fa or $fs");
  }
  return static_cast<std::uint32_t>(count);
}

}  // namespace csgsim::solids
