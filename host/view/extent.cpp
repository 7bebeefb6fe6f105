#include "host/view/extent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "host/view/quadric_extent.h"

namespace csgsim::view {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

const facet::Box everywhere{glm::dvec3(-infinite), glm::dvec3(infinite)};

/// Relative rounding error of a coordinate that is projected into the picture and back.
constexpr double noise = 1e-12;

/// Corners of the part of a solid behind the near plane, in eye space.
std::vector<glm::dvec3> clip_near(const facet::Convex& solid, const EyeSpace& space, double near) {
  std::vector<glm::dvec3> in_eye;
  in_eye.reserve(solid.vertices.size());
  for (const glm::dvec3& vertex : solid.vertices) in_eye.push_back(space.to_eye(vertex));
  if (!space.perspective) return in_eye;
  std::vector<glm::dvec3> kept;
  for (const glm::dvec3& vertex : in_eye) {
    if (vertex.z >= near) kept.push_back(vertex);
  }
  for (const auto& [first, second] : solid.edges) {
    const glm::dvec3& a = in_eye[first];
    const glm::dvec3& b = in_eye[second];
    if ((a.z < near) != (b.z < near)) kept.push_back(a + (b - a) * ((near - a.z) / (b.z - a.z)));
  }
  return kept;
}

double value_at(const Sampling& sampling, const RealLinear& linear, const glm::dvec3& place) {
  return linear.at_centre + linear.a * (place.x - (sampling.width - 1.0) / 2.0) +
         linear.b * (place.y - (sampling.height - 1.0) / 2.0);
}

/// Maximum error, anywhere in the picture, of a function whose coefficients have `fraction_bits` fraction bits.
double rounding(const Sampling& sampling, unsigned fraction_bits) {
  return (1.0 + sampling.width / 2.0 + sampling.height / 2.0) * std::ldexp(0.5, -static_cast<int>(fraction_bits));
}

/// How far rounding of the planes may move half-spaces outwards, in depth steps and pixels.
struct Moves {
  explicit Moves(const Sampling& sampling)
      : step(1.0 + rounding(sampling, sampling.fraction_bits)),
        edge(sampling.edge_on_fraction + rounding(sampling, edge_fraction_bits(sampling))) {}

  double step;  ///< for surfaces, in depth steps: rounding down, and the coefficients' rounding
  double edge;  ///< for edge tests, in pixels: from the plane to where it crosses half the depth range, and rounding
};

/// How far rounding may move a half-space outwards, relative to its slack at a point.
double relative_move(const View& view, facet::Halfspace halfspace, const glm::dvec3& inside, const Moves& moves) {
  const ScreenPlane& plane = view.planes[halfspace.plane];
  const double value = value_at(view.sampling, plane.real, inside);
  const auto [slack, move] = [&]() -> std::pair<double, double> {
    switch (side_of(plane, halfspace)) {
      case Side::front: return {inside.z - value, moves.step};
      case Side::back: return {value - inside.z, moves.step};
      case Side::edge_positive: return {value, moves.edge};
      case Side::edge_negative: return {-value, moves.edge};
    }
    return {0.0, moves.step};
  }();
  return slack > 0.0 ? move / slack : infinite;
}

PixelRect touched_pixels(const std::vector<glm::dvec3>& places, const Sampling& sampling) {
  double x0 = infinite;
  double y0 = infinite;
  double x1 = -infinite;
  double y1 = -infinite;
  for (const glm::dvec3& place : places) {
    x0 = std::min(x0, place.x);
    x1 = std::max(x1, place.x);
    y0 = std::min(y0, place.y);
    y1 = std::max(y1, place.y);
  }
  const auto to_pixel = [](double value) {
    return static_cast<std::int32_t>(std::clamp(value, -1.0, static_cast<double>(isa::max_array_side) + 1.0));
  };
  // Edge-on planes differ from their drawn position by at most half their sideways movement over the depth range; the
  // remainder is for rounding.
  const double margin = sampling.edge_on_fraction + 1.0 / 64;
  const PixelRect screen{0, 0, static_cast<std::int32_t>(sampling.width) - 1,
                         static_cast<std::int32_t>(sampling.height) - 1};
  return common({to_pixel(std::ceil(x0 - margin)), to_pixel(std::ceil(y0 - margin)), to_pixel(std::floor(x1 + margin)),
                 to_pixel(std::floor(y1 + margin))},
                screen);
}

/// Narrows the depths to those that the planes allow over the rectangle, computed as the machine does.
void narrow_by_planes(Extent& extent, const facet::Convex& solid, const View& view) {
  for (const facet::Halfspace& halfspace : solid.halfspaces) {
    const ScreenPlane& plane = view.planes[halfspace.plane];
    if (!plane.representable || plane.kind == PlaneKind::edge) continue;
    const Range range = range_over(plane.linear, extent.pixels);
    if (side_of(plane, halfspace) == Side::front) {
      extent.z_low = std::max(extent.z_low, range.low >> view.sampling.fraction_bits);
    } else {
      extent.z_high = std::min(extent.z_high, range.high >> view.sampling.fraction_bits);
    }
  }
}

/// In picture space, a solid is the intersection of half-spaces g(p) <= 0. If rounding moves each of them to g(p) <= d,
/// and g(inside) <= -s < 0, then scaling the solid about `inside` by 1 + max d/s gives a solid that contains the
/// rounded one. Returns max d/s, which is infinite for a solid without an interior.
double growth_about(const glm::dvec3& inside, const facet::Convex& solid, bool near_cuts, const View& view,
                    const PixelRect& pixels) {
  // The cap of a solid that the near plane cuts at depth 1 is at depth 0.
  double growth = near_cuts ? 1.0 / std::max(inside.z - 1.0, 0.0) : 0.0;
  const Moves moves(view.sampling);
  for (const facet::Halfspace& halfspace : solid.halfspaces) {
    growth = std::max(growth, relative_move(view, halfspace, inside, moves));
  }
  for (const facet::QuadricSide side : solid.quadrics) {
    growth = std::max(growth, required_growth(view.quadrics[side.quadric], side, inside, view, pixels));
  }
  return growth;
}

/// The box in model space of points in the picture; infinite if a point is not in front of the eye.
facet::Box box_around(const std::vector<glm::dvec3>& places, const EyeSpace& space, const View& view) {
  facet::Box box;
  for (const glm::dvec3& place : places) {
    const double distance = isa::distance_at(view.depth, view.sampling.z_bits, place.z);
    if (space.perspective && !(distance > 0.0 && std::isfinite(distance))) return everywhere;
    box = hull(box, space.to_model(space.from_picture({place.x, place.y, distance})));
  }
  const glm::dvec3 more = noise * glm::max(glm::abs(box.low), glm::abs(box.high));
  return {box.low - more, box.high + more};
}

/// The corners of the solid's block of pixels and depths, which contains the solid in spite of rounding.
std::vector<glm::dvec3> block_corners(const Extent& extent) {
  std::vector<glm::dvec3> corners;
  for (const std::int32_t x : {extent.pixels.x0, extent.pixels.x1}) {
    for (const std::int32_t y : {extent.pixels.y0, extent.pixels.y1}) {
      for (const std::int64_t z : {extent.z_low, extent.z_high}) corners.emplace_back(x, y, static_cast<double>(z));
    }
  }
  return corners;
}

}  // namespace

PixelRect vertex_pixels(const facet::Convex& solid, const EyeSpace& space, const View& view) {
  std::vector<glm::dvec3> places = clip_near(solid, space, view.depth.near);
  for (glm::dvec3& place : places) place = space.to_picture(place);
  return places.empty() ? PixelRect{} : touched_pixels(places, view.sampling);
}

Extent make_extent(const facet::Convex& solid, const EyeSpace& space, const View& view) {
  const Sampling& sampling = view.sampling;
  std::vector<glm::dvec3> places = clip_near(solid, space, view.depth.near);
  if (places.empty()) return {};
  glm::dvec3 inside(0);
  const bool near_cuts =
      space.perspective && std::any_of(solid.vertices.begin(), solid.vertices.end(), [&](const glm::dvec3& vertex) {
        return space.to_eye(vertex).z < view.depth.near;
      });
  double nearest = infinite;
  double farthest = -infinite;
  for (glm::dvec3& place : places) {
    nearest = std::min(nearest, place.z);
    farthest = std::max(farthest, place.z);
    place = space.to_picture(place);
    place.z = isa::depth_of(view.depth, sampling.z_bits, place.z);
    inside += place / static_cast<double>(places.size());
  }
  const std::int64_t top = (std::int64_t{1} << sampling.z_bits) - 1;
  Extent extent{touched_pixels(places, sampling), 0, top, everywhere, near_cuts, infinite, {}};
  if (extent.empty()) return extent;
  const double growth = growth_about(inside, solid, near_cuts, view, extent.pixels);
  if (std::isfinite(growth)) {
    double low = infinite;
    double high = -infinite;
    for (glm::dvec3& place : places) {
      place += growth * (place - inside);
      low = std::min(low, place.z);
      high = std::max(high, place.z);
    }
    const auto to_step = [&](double value) {
      return static_cast<std::int64_t>(std::clamp(value, -1.0, static_cast<double>(top) + 1.0));
    };
    extent.z_low = std::max<std::int64_t>(0, to_step(std::floor(low)));
    extent.z_high = std::min(top, to_step(std::ceil(high)));
    extent.box = box_around(places, space, view);
    extent.corners = std::move(places);
    // A plane of the model is affine in the picture, where its values at the corners are divided by their distances.
    extent.looseness = growth / (1 + growth) * (space.perspective ? farthest / nearest : 1.0);
  }
  narrow_by_planes(extent, solid, view);
  for (const facet::QuadricSide side : solid.quadrics)
    narrow_to_quadric(extent, view.quadrics[side.quadric], side, view);
  if (!solid.quadrics.empty() && extent.corners.empty() && !extent.empty()) {
    extent.corners = block_corners(extent);
    extent.box = box_around(extent.corners, space, view);
  }
  return extent;
}

}  // namespace csgsim::view
