#include "host/emit/light_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "host/emit/facet_geometry.h"
#include "host/model/shapes.h"
#include "host/view/fast_sphere.h"
#include "host/view/projection.h"
#include "hw/isa/depth_scale.h"

namespace csgsim::emit {

namespace {

/// Number of sample positions around an axis and along it.
constexpr int around = 48;
constexpr int along = 13;

/// A pivot below this fraction of the greatest counts as 0: the samples lie in a plane.
constexpr double min_pivot = 1e-12;

/// Sample positions on a shape; empty if it has no curved surface.
std::vector<model::SurfacePosition> sample_places(const model::Shape& shape) {
  std::vector<model::SurfacePosition> places;
  for (int ring = 0; ring < along; ++ring) {
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * std::numbers::pi * i / around;
      const auto place = model::surface_position_at(shape, {std::cos(angle), std::sin(angle)}, (ring + 0.5) / along);
      if (place) places.push_back(*place);
    }
  }
  return places;
}

/// Coordinates of a sample: 1, column and row from the picture's centre, depth steps.
using Coordinates = std::array<double, 4>;

struct Sample {
  Coordinates at;
  double cosine;
};

double cosine_at(const lighting::CameraSpaceLight& light, const glm::dvec3& place, const glm::dvec3& normal) {
  return glm::dot(light.is_point ? glm::normalize(light.where - place) : light.where, normal);
}

/// The depth at which a point of the surface is drawn; `place` is its column, row and distance from the eye.
double drawn_depth(const view::View& view, const Facet& facet, const glm::dvec3& place) {
  const view::ScreenQuadric& quadric = view.quadrics[facet.quadric.quadric];
  if (quadric.kind == view::ScreenQuadricKind::paraboloid)
    return view::paraboloid_depth(quadric, view.sampling, place.x, place.y, facet.at == At::quadric_near);
  return isa::depth_of(view.depth, view.sampling.z_bits, place.z);
}

/// Mean distance in steps by which the floor operations of a depth move it behind drawn_depth
/// (host/view/screen_quadric.h). The floors of the middle and the root cancel, unless the middle is constant.
double off_steps(const view::View& view, const Facet& facet) {
  const view::ScreenQuadric& quadric = view.quadrics[facet.quadric.quadric];
  if (quadric.kind == view::ScreenQuadricKind::paraboloid) return facet.at == At::quadric_near ? -0.5 : 0.5;
  if (quadric.middle.a != 0 || quadric.middle.b != 0) return 0;
  const std::int64_t one = std::int64_t{1} << view.sampling.fraction_bits;
  return 0.5 - static_cast<double>(quadric.middle.c & (one - 1)) / static_cast<double>(one);
}

std::vector<Sample> take_samples(const Context& context, const Facet& facet, const lighting::CameraSpaceLight& light) {
  const model::Primitive& primitive = context.tree.primitives[facet.primitive];
  const glm::dmat3 normals = glm::transpose(glm::inverse(glm::dmat3(primitive.transform)));
  const double sign = context.complemented(facet.primitive) ? -1.0 : 1.0;
  const view::View& view = context.view;
  const view::EyeSpace space = view::eye_space(view.camera, view.sampling);
  std::vector<Sample> samples;
  for (const model::SurfacePosition& own : sample_places(primitive.shape)) {
    const glm::dvec3 in_eye = space.to_eye(glm::dvec3(primitive.transform * glm::dvec4(own.at, 1)));
    const glm::dvec3 normal = in_camera_axes(view.camera, sign * glm::normalize(normals * own.normal));
    const glm::dvec3 from_eye = space.perspective ? in_eye : glm::dvec3(0, 0, 1);
    if (glm::dot(normal, from_eye) >= 0 || (space.perspective && in_eye.z < view.depth.near)) continue;
    const glm::dvec3 place = space.to_picture(in_eye);
    const double depth = drawn_depth(view, facet, place);
    samples.push_back(
        {{1.0, place.x - (view.sampling.width - 1.0) / 2.0, place.y - (view.sampling.height - 1.0) / 2.0, depth},
         cosine_at(light, in_eye, normal)});
  }
  return samples;
}

/// The largest magnitude of each coordinate over the samples, or 1 if it is 0. Divided by these, all coordinates have
/// equal weight.
Coordinates coordinate_sizes(const std::vector<Sample>& samples) {
  Coordinates sizes{};
  for (const Sample& one : samples)
    for (std::size_t i = 0; i < sizes.size(); ++i) sizes[i] = std::max(sizes[i], std::abs(one.at[i]));
  for (double& size : sizes) size = size > 0 ? size : 1.0;
  return sizes;
}

constexpr std::size_t none = 4;

/// Solves the normal equations of least squares; undetermined unknowns become 0.
Coordinates solve(std::array<std::array<double, 5>, 4> equations) {
  std::array<bool, 4> used{};
  std::array<std::size_t, 4> pivot_of{none, none, none, none};
  double greatest = 0;
  for (std::size_t i = 0; i < 4; ++i) greatest = std::max(greatest, equations[i][i]);
  for (std::size_t column = 0; column < 4; ++column) {
    std::size_t best = none;
    for (std::size_t row = 0; row < 4; ++row)
      if (!used[row] && (best == none || std::abs(equations[row][column]) > std::abs(equations[best][column])))
        best = row;
    if (std::abs(equations[best][column]) <= min_pivot * greatest) continue;
    used[best] = true;
    pivot_of[column] = best;
    for (std::size_t row = 0; row < 4; ++row) {
      if (row == best) continue;
      const double factor = equations[row][column] / equations[best][column];
      for (std::size_t i = column; i < 5; ++i) equations[row][i] -= factor * equations[best][i];
    }
  }
  Coordinates result{};
  for (std::size_t column = 0; column < 4; ++column)
    if (pivot_of[column] != none) result[column] = equations[pivot_of[column]][4] / equations[pivot_of[column]][column];
  return result;
}

}  // namespace

LightFit fit_light(const Context& context, const Facet& facet, const lighting::CameraSpaceLight& light) {
  const std::vector<Sample> samples = take_samples(context, facet, light);
  const Coordinates sizes = coordinate_sizes(samples);
  std::array<std::array<double, 5>, 4> equations{};
  for (const Sample& one : samples) {
    for (std::size_t row = 0; row < 4; ++row) {
      const double at = one.at[row] / sizes[row];
      for (std::size_t column = 0; column < 4; ++column) equations[row][column] += at * one.at[column] / sizes[column];
      equations[row][4] += at * one.cosine;
    }
  }
  Coordinates found = solve(equations);
  for (std::size_t i = 0; i < found.size(); ++i) found[i] /= sizes[i];
  double greatest = 0;
  double nearest = samples.empty() ? 0.0 : samples.front().at[3];
  double farthest = nearest;
  for (const Sample& one : samples) {
    greatest = std::max(greatest, std::inner_product(found.begin(), found.end(), one.at.begin(), 0.0));
    nearest = std::min(nearest, one.at[3]);
    farthest = std::max(farthest, one.at[3]);
  }
  return {{found[1], found[2], found[0]}, found[3], greatest, (nearest + farthest) / 2, off_steps(context.view, facet)};
}

}  // namespace csgsim::emit
