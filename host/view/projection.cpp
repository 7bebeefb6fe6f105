#include "host/view/projection.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "host/model/hypotenuse.h"
#include "host/view/extent.h"
#include "host/view/eye_space.h"
#include "host/view/fast_sphere.h"
#include "host/view/quadric_projection.h"
#include "hw/base/error.h"
#include "hw/isa/depth_scale.h"

namespace csgsim::view {

namespace {

/// Minimum of the default near distance of a perspective view, relative to the far distance. It limits the loss of
/// depth resolution to 8 bits.
constexpr double near_floor = 1.0 / 256;

/// Maximum sample offset, pixels.
constexpr double max_offset = 2;

void check(const Sampling& sampling) {
  if (sampling.width < 1 || sampling.height < 1 || sampling.width > isa::max_array_side ||
      sampling.height > isa::max_array_side) {
    throw InputError("the picture's sides must be 1 to " + std::to_string(isa::max_array_side) + " pixels");
  }
  if (sampling.z_bits < min_z_bits || sampling.z_bits > max_z_bits) {
    throw InputError("z must have " + std::to_string(min_z_bits) + " to " + std::to_string(max_z_bits) + " bits");
  }
  if (sampling.fraction_bits > max_fraction_bits)
    throw InputError("coefficients must have 0 to " + std::to_string(max_fraction_bits) + " fraction bits");
  if (!(sampling.edge_on_fraction > 0.0 && sampling.edge_on_fraction <= 1.0)) {
    throw InputError("the edge-on fraction must be above 0 and at most 1 pixel");
  }
  if (sampling.near && !(*sampling.near > 0.0 && std::isfinite(*sampling.near))) {
    throw InputError("the near plane must be at a finite distance above 0");
  }
  if (!(std::abs(sampling.offset.x) <= max_offset && std::abs(sampling.offset.y) <= max_offset)) {
    throw InputError("pixels must be sampled within two pixels of their centres");
  }
}

/// Minimum near distance, relative to the far distance. With smaller distances too few of a double's 53 bits
/// distinguish depths.
constexpr double min_near_ratio = 0x1p-48;

void check_near(double near, double far) {
  if (near < far * min_near_ratio) {
    throw InputError(
        fmt::format("the near plane at {:g} is too near to distinguish the model's depths, which end at {:g}; set "
                    "--near to {:.3g} or more",
                    near, far, far * min_near_ratio));
  }
  if (near > far) {
    throw InputError("the near plane is behind the whole model, which ends at a distance of " + std::to_string(far) +
                     "; bring --near closer");
  }
}

/// Narrows the depths of a box to those of an ellipsoid, which has a smaller range than its box.
void narrow_depth(facet::Box& box, const facet::Convex& solid, const facet::QuadricTable& quadrics,
                  const EyeSpace& space) {
  if (solid.quadrics.size() != 1) return;
  const facet::Quadric& quadric = quadrics.quadrics()[solid.quadrics.front().quadric];
  if (quadric.kind != facet::QuadricKind::ellipsoid) return;
  const auto& rows = quadric.to_unit;
  const glm::dmat3 to_unit = glm::transpose(glm::dmat3(rows[0], rows[1], rows[2]));
  const double half = glm::length(space.axes.forward * glm::inverse(to_unit));
  const double middle = space.to_eye(quadric.origin + quadrics.centre()).z;
  box.low.z = std::max(box.low.z, middle - half);
  box.high.z = std::min(box.high.z, middle + half);
}

isa::DepthScale fit_depth(const facet::Geometry& geometry, const model::Tree& tree, const EyeSpace& space,
                          const Sampling& sampling) {
  std::vector<facet::Box> boxes;
  for (const facet::Convex& solid : geometry.solids) {
    facet::Box box;
    for (const glm::dvec3& vertex : solid.vertices) box = hull(box, space.to_eye(vertex));
    narrow_depth(box, solid, geometry.quadrics, space);
    boxes.push_back(box);
  }
  const facet::Box box = facet::fold_boxes(tree, boxes);
  double near = box.empty() ? 1.0 : box.low.z;
  double far = box.empty() ? 2.0 : box.high.z;
  if (space.perspective) {
    if (far <= 0.0) return {true, 1.0, 2.0};  // everything is behind the eye
    if (box.empty() && sampling.near) far = 2.0 * *sampling.near;
    near = sampling.near ? *sampling.near : std::max(near, far * near_floor);
    if (sampling.near) check_near(near, far);
  }
  // The range is never empty, so that a flat model still has a front and a back.
  const double least = std::max({std::abs(near), std::abs(far), std::numeric_limits<double>::min()}) * 1e-9;
  if (!(far - near > least)) far = near + least;
  return {space.perspective, near, far};
}

/// A canonical plane in eye space: normal . p + offset.
struct EyePlane {
  glm::dvec3 normal;
  double offset;
};

EyePlane to_eye(const EyeSpace& space, const facet::Plane& plane, const glm::dvec3& centre) {
  return {{glm::dot(plane.normal, space.axes.right), glm::dot(plane.normal, space.axes.up),
           glm::dot(plane.normal, space.axes.forward)},
          plane.offset + glm::dot(plane.normal, space.eye - centre)};
}

/// The plane as an edge test: its value on each pixel's ray at the middle of the depth range, scaled to pixels.
RealLinear edge_line(const EyeSpace& space, const isa::DepthScale& scale, const EyePlane& plane) {
  const double a = plane.normal.x * space.pixel;
  const double b = -plane.normal.y * space.pixel;
  const double middle = space.perspective ? plane.normal.z + plane.offset * (1.0 / scale.near + 1.0 / scale.far) / 2.0
                                          : plane.normal.z * (scale.near + scale.far) / 2.0 + plane.offset;
  const double length = std::max(std::abs(a), std::abs(b));
  return length > 0.0 ? RealLinear{a / length, b / length, middle / length} : RealLinear{0, 0, middle};
}

/// The plane's depth at every pixel; infinite coefficients if it is seen exactly edge-on.
RealLinear depth_plane(const EyeSpace& space, const isa::DepthScale& scale, unsigned z_bits, const EyePlane& plane) {
  const glm::dvec3& n = plane.normal;
  const double steps = isa::depth_steps(z_bits);
  if (space.perspective) {
    // The ray (X/Z, Y/Z) meets the plane at 1/Z = -(n.x X/Z + n.y Y/Z + n.z) / offset.
    const double scaled = steps / (1.0 / scale.near - 1.0 / scale.far) / plane.offset;
    return {n.x * space.pixel * scaled, -n.y * space.pixel * scaled,
            1.0 + steps / (1.0 - scale.near / scale.far) + n.z * scaled};
  }
  const double scaled = steps / (scale.far - scale.near);
  return {-n.x * space.pixel / n.z * scaled, n.y * space.pixel / n.z * scaled,
          1.0 + (-plane.offset / n.z - scale.near) * scaled};
}

/// Whether the edge has its canonical orientation. A point where the line is 0 then belongs to the side of the points
/// infinitely close to the right or, for horizontal lines, below.
bool points_right(const FixedLinear& line) { return line.a > 0 || (line.a == 0 && line.b >= 0); }

/// `line` must be a function of the pixels' sample positions.
ScreenPlane make_edge(const RealLinear& line, const Sampling& sampling) {
  ScreenPlane edge;
  edge.kind = PlaneKind::edge;
  edge.real = line;
  const auto fixed = to_fixed(line, edge_fraction_bits(sampling), sampling.width, sampling.height);
  edge.representable = fixed.has_value();
  if (fixed) edge.linear = *fixed;
  // The positive half-space is normal . p + offset <= 0, where the line is negative.
  edge.positive = false;
  if (!points_right(edge.linear)) {
    edge.linear = {-edge.linear.a, -edge.linear.b, -edge.linear.c};
    edge.real = {-line.a, -line.b, -line.at_centre};
    edge.positive = true;
  }
  return edge;
}

ScreenPlane make_screen_plane(const EyeSpace& space, const isa::DepthScale& scale, const Sampling& sampling,
                              const EyePlane& plane) {
  const RealLinear depth = depth_plane(space, scale, sampling.z_bits, plane);
  const double slope = model::hypotenuse(depth.a, depth.b);
  const double steepest = std::ldexp(1.0, static_cast<int>(sampling.z_bits)) / sampling.edge_on_fraction;
  if (!(slope <= steepest) || !std::isfinite(depth.at_centre))
    return make_edge(as_sampled(edge_line(space, scale, plane), sampling), sampling);
  ScreenPlane surface;
  surface.real = as_sampled(depth, sampling);
  // The eye is outside the positive half-space.
  surface.positive = space.perspective ? plane.offset > 0.0 : plane.normal.z < 0.0;
  const auto fixed = to_fixed(surface.real, sampling.fraction_bits, sampling.width, sampling.height);
  surface.representable = fixed.has_value();
  if (fixed) surface.linear = *fixed;
  return surface;
}

void add_quadrics(View& view, const facet::Geometry& geometry, const EyeSpace& space) {
  const std::vector<facet::Quadric>& quadrics = geometry.quadrics.quadrics();
  if (quadrics.empty()) return;
  std::vector<PixelRect> touched(quadrics.size());
  for (const facet::Convex& solid : geometry.solids) {
    if (solid.quadrics.empty()) continue;
    const PixelRect pixels = vertex_pixels(solid, space, view);
    for (const facet::QuadricSide side : solid.quadrics) touched[side.quadric] = hull(touched[side.quadric], pixels);
  }
  view.quadrics.reserve(quadrics.size());
  for (std::size_t i = 0; i < quadrics.size(); ++i) {
    const auto make = geometry.fast_spheres ? make_fast_sphere : make_screen_quadric;
    view.quadrics.push_back(make(space, view, quadrics[i], geometry.quadrics.centre(), touched[i]));
  }
}

}  // namespace

Side side_of(const ScreenPlane& plane, bool positive) {
  const bool same = plane.positive == positive;
  if (plane.kind == PlaneKind::edge) return same ? Side::edge_positive : Side::edge_negative;
  return same ? Side::front : Side::back;
}

Side side_of(const ScreenPlane& plane, facet::Halfspace halfspace) { return side_of(plane, halfspace.positive); }

RealLinear as_sampled(const RealLinear& linear, const Sampling& sampling) {
  return {linear.a, linear.b, linear.at_centre + linear.a * sampling.offset.x + linear.b * sampling.offset.y};
}

EyeSpace eye_space(const Camera& camera, const Sampling& sampling) {
  const bool perspective = camera.projection == Projection::perspective;
  const double half = perspective ? half_height_per_distance() : half_height(camera);
  return {basis(camera),
          camera.eye,
          perspective,
          2.0 * half / sampling.height,
          (sampling.width - 1.0) / 2.0 - sampling.offset.x,
          (sampling.height - 1.0) / 2.0 - sampling.offset.y};
}

ScreenPlane screen_plane(const View& view, const facet::Plane& plane, const glm::dvec3& centre) {
  const EyeSpace space = eye_space(view.camera, view.sampling);
  return make_screen_plane(space, view.depth, view.sampling, to_eye(space, plane, centre));
}

View make_view(const facet::Geometry& geometry, const model::Tree& tree, const Camera& camera,
               const Sampling& sampling) {
  check(sampling);
  const EyeSpace space = eye_space(camera, sampling);
  View view;
  view.camera = camera;
  view.sampling = sampling;
  view.depth = fit_depth(geometry, tree, space, sampling);
  view.planes.reserve(geometry.planes.planes().size());
  view.extents.reserve(geometry.solids.size());
  for (const facet::Plane& plane : geometry.planes.planes()) {
    view.planes.push_back(
        make_screen_plane(space, view.depth, sampling, to_eye(space, plane, geometry.planes.centre())));
  }
  add_quadrics(view, geometry, space);
  for (const facet::Convex& solid : geometry.solids) view.extents.push_back(make_extent(solid, space, view));
  const double far_step = (view.depth.far - view.depth.near) / isa::depth_steps(sampling.z_bits);
  view.depth_step = space.perspective ? far_step * view.depth.far / view.depth.near : far_step;
  return view;
}

}  // namespace csgsim::view
