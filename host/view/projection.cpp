#include "host/view/projection.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "hw/isa/depth_scale.h"
#include "hw/isa/error.h"

namespace csgsim::view {

namespace {

/// The nearest a perspective view's near plane comes by itself, as a part of the distance to the far plane: 8 of the
/// depth bits are spent on nearness then.
constexpr double near_floor = 1.0 / 256;

/// Maps model space to eye space and eye space to the picture.
struct Frame {
  Basis axes;
  glm::dvec3 eye;
  bool perspective;
  double pixel;     ///< orthographic: model units a pixel; perspective: tangent a pixel
  double middle_x;  ///< column and row that the view axis meets
  double middle_y;

  [[nodiscard]] glm::dvec3 to_eye(const glm::dvec3& point) const {
    const glm::dvec3 d = point - eye;
    return {glm::dot(d, axes.right), glm::dot(d, axes.up), glm::dot(d, axes.forward)};
  }
};

/// A point in the picture: column and row in pixels, pixel centres at integers.
struct PicturePoint {
  double x;
  double y;
};

PicturePoint to_picture(const Frame& frame, const glm::dvec3& in_eye) {
  const double unit = frame.perspective ? frame.pixel * in_eye.z : frame.pixel;
  return {frame.middle_x + in_eye.x / unit, frame.middle_y - in_eye.y / unit};
}

void check(const Sampling& sampling) {
  if (sampling.width < 1 || sampling.height < 1 || sampling.width > isa::max_array_side ||
      sampling.height > isa::max_array_side) {
    throw InputError("the picture's sides have to be 1 to " + std::to_string(isa::max_array_side) + " pixels");
  }
  if (sampling.z_bits < 4 || sampling.z_bits > 30) throw InputError("z has to have 4 to 30 bits");
  if (sampling.fraction_bits > 20) throw InputError("coefficients have to have 0 to 20 fraction bits");
  if (!(sampling.edge_on_fraction > 0.0 && sampling.edge_on_fraction <= 1.0)) {
    throw InputError("the edge-on fraction has to be above 0 and at most 1 pixel");
  }
  if (sampling.near && !(*sampling.near > 0.0 && std::isfinite(*sampling.near))) {
    throw InputError("the near plane has to be at a finite distance above 0");
  }
}

void check_near(double near, double far) {
  if (near > far) {
    throw InputError("the near plane is behind the whole model, which ends at a distance of " + std::to_string(far) +
                     "; bring --near closer");
  }
}

isa::DepthScale fit_depth(const facet::Scene& scene, const model::Tree& tree, const Frame& frame,
                          const Sampling& sampling) {
  std::vector<facet::Box> boxes;
  for (const facet::Convex& solid : scene.solids) {
    facet::Box box;
    for (const glm::dvec3& vertex : solid.vertices) box = hull(box, frame.to_eye(vertex));
    boxes.push_back(box);
  }
  const facet::Box box = facet::fold_boxes(tree, boxes);
  double near = box.empty() ? 1.0 : box.low.z;
  double far = box.empty() ? 2.0 : box.high.z;
  if (frame.perspective) {
    if (far <= 0.0) return {true, 1.0, 2.0};  // all behind the eye
    near = sampling.near ? *sampling.near : std::max(near, far * near_floor);
    if (sampling.near) check_near(near, far);
  }
  // Never a range of nothing: a flat model still has a front and a back.
  const double least = std::max({std::abs(near), std::abs(far), std::numeric_limits<double>::min()}) * 1e-9;
  if (!(far - near > least)) far = near + least;
  return {frame.perspective, near, far};
}

/// A canonical plane in eye space: normal . p + offset.
struct EyePlane {
  glm::dvec3 normal;
  double offset;
};

EyePlane to_eye(const Frame& frame, const facet::Plane& plane, const glm::dvec3& centre) {
  return {{glm::dot(plane.normal, frame.axes.right), glm::dot(plane.normal, frame.axes.up),
           glm::dot(plane.normal, frame.axes.forward)},
          plane.offset + glm::dot(plane.normal, frame.eye - centre)};
}

/// The plane as an edge test: its value on the ray of each pixel where the depth range is half passed, scaled to
/// pixels.
RealLinear edge_line(const Frame& frame, const isa::DepthScale& scale, const EyePlane& plane) {
  const double a = plane.normal.x * frame.pixel;
  const double b = -plane.normal.y * frame.pixel;
  const double middle = frame.perspective ? plane.normal.z + plane.offset * (1.0 / scale.near + 1.0 / scale.far) / 2.0
                                          : plane.normal.z * (scale.near + scale.far) / 2.0 + plane.offset;
  const double length = std::max(std::abs(a), std::abs(b));
  return length > 0.0 ? RealLinear{a / length, b / length, middle / length} : RealLinear{0, 0, middle};
}

/// The plane's depth at every pixel; infinite coefficients if it is seen edge-on exactly.
RealLinear depth_plane(const Frame& frame, const isa::DepthScale& scale, unsigned z_bits, const EyePlane& plane) {
  const glm::dvec3& n = plane.normal;
  const double steps = isa::depth_steps(z_bits);
  if (frame.perspective) {
    // On a ray (X/Z, Y/Z) the plane is met at 1/Z = -(n.x X/Z + n.y Y/Z + n.z) / offset.
    const double scaled = steps / (1.0 / scale.near - 1.0 / scale.far) / plane.offset;
    return {n.x * frame.pixel * scaled, -n.y * frame.pixel * scaled,
            1.0 + steps / (1.0 - scale.near / scale.far) + n.z * scaled};
  }
  const double scaled = steps / (scale.far - scale.near);
  return {-n.x * frame.pixel / n.z * scaled, n.y * frame.pixel / n.z * scaled,
          1.0 + (-plane.offset / n.z - scale.near) * scaled};
}

/// The canonical orientation of an edge: a zero of the line belongs to the side that the pixel centre falls on when it
/// is moved right, or, along vertical moves only, down, by less than anything.
bool points_right(const FixedLinear& line) { return line.a > 0 || (line.a == 0 && line.b >= 0); }

ScreenPlane make_edge(const RealLinear& line, const Sampling& sampling) {
  ScreenPlane edge;
  edge.kind = PlaneKind::edge;
  edge.real = line;
  const auto fixed = to_fixed(line, edge_fraction_bits(sampling), sampling.width, sampling.height);
  edge.representable = fixed.has_value();
  if (fixed) edge.linear = *fixed;
  // normal . p + offset <= 0 is the positive half-space: there the line is negative.
  edge.positive = false;
  if (!points_right(edge.linear)) {
    edge.linear = {-edge.linear.a, -edge.linear.b, -edge.linear.c};
    edge.real = {-line.a, -line.b, -line.at_centre};
    edge.positive = true;
  }
  return edge;
}

ScreenPlane make_screen_plane(const Frame& frame, const isa::DepthScale& scale, const Sampling& sampling,
                              const EyePlane& plane) {
  const RealLinear depth = depth_plane(frame, scale, sampling.z_bits, plane);
  const double slope = std::hypot(depth.a, depth.b);
  const double steepest = std::ldexp(1.0, static_cast<int>(sampling.z_bits)) / sampling.edge_on_fraction;
  if (!(slope <= steepest) || !std::isfinite(depth.at_centre))
    return make_edge(edge_line(frame, scale, plane), sampling);
  ScreenPlane surface;
  surface.real = depth;
  // The eye is outside the positive half-space.
  surface.positive = frame.perspective ? plane.offset > 0.0 : plane.normal.z < 0.0;
  const auto fixed = to_fixed(depth, sampling.fraction_bits, sampling.width, sampling.height);
  surface.representable = fixed.has_value();
  if (fixed) surface.linear = *fixed;
  return surface;
}

/// Vertices of the part of a solid from the near plane on, in eye space.
std::vector<glm::dvec3> clip_near(const facet::Convex& solid, const Frame& frame, double near) {
  std::vector<glm::dvec3> in_eye;
  in_eye.reserve(solid.vertices.size());
  for (const glm::dvec3& vertex : solid.vertices) in_eye.push_back(frame.to_eye(vertex));
  if (!frame.perspective) return in_eye;
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

std::int32_t to_pixel(double value) {
  return static_cast<std::int32_t>(std::clamp(value, -1.0, static_cast<double>(isa::max_array_side) + 1.0));
}

std::int64_t to_step(double value, std::int64_t top) {
  return static_cast<std::int64_t>(std::clamp(value, -16.0, static_cast<double>(top) + 16.0));
}

Extent make_extent(const facet::Convex& solid, const Frame& frame, const isa::DepthScale& scale,
                   const Sampling& sampling) {
  const std::vector<glm::dvec3> points = clip_near(solid, frame, scale.near);
  if (points.empty()) return {};
  double x0 = std::numeric_limits<double>::infinity();
  double y0 = x0;
  double z0 = x0;
  double x1 = -x0;
  double y1 = -x0;
  double z1 = -x0;
  for (const glm::dvec3& point : points) {
    const PicturePoint place = to_picture(frame, point);
    const double depth = isa::depth_of(scale, sampling.z_bits, point.z);
    x0 = std::min(x0, place.x);
    x1 = std::max(x1, place.x);
    y0 = std::min(y0, place.y);
    y1 = std::max(y1, place.y);
    z0 = std::min(z0, depth);
    z1 = std::max(z1, depth);
  }
  // Edge-on planes are met half their depth range away from where they are drawn at most; the rest is for rounding.
  const double margin = sampling.edge_on_fraction + 1.0 / 64;
  const std::int64_t top = (std::int64_t{1} << sampling.z_bits) - 1;
  const PixelRect screen{0, 0, static_cast<std::int32_t>(sampling.width) - 1,
                         static_cast<std::int32_t>(sampling.height) - 1};
  const PixelRect touched{to_pixel(std::ceil(x0 - margin)), to_pixel(std::ceil(y0 - margin)),
                          to_pixel(std::floor(x1 + margin)), to_pixel(std::floor(y1 + margin))};
  return {common(touched, screen), std::max<std::int64_t>(0, to_step(std::floor(z0), top) - depth_margin(sampling)),
          std::min(top, to_step(std::ceil(z1), top) + depth_margin(sampling))};
}

}  // namespace

std::int64_t depth_margin(const Sampling& sampling) {
  const double off =
      (1.0 + sampling.width / 2.0 + sampling.height / 2.0) * std::ldexp(0.5, -static_cast<int>(sampling.fraction_bits));
  return 4 + static_cast<std::int64_t>(std::ceil(4.0 * off));
}

Side side_of(const ScreenPlane& plane, facet::Halfspace halfspace) {
  const bool same = plane.positive == halfspace.positive;
  if (plane.kind == PlaneKind::edge) return same ? Side::edge_positive : Side::edge_negative;
  return same ? Side::front : Side::back;
}

View make_view(const facet::Scene& scene, const model::Tree& tree, const Camera& camera, const Sampling& sampling) {
  check(sampling);
  const bool perspective = camera.projection == Projection::perspective;
  const double half = perspective ? half_height_per_distance() : half_height(camera);
  const Frame frame{basis(camera),
                    camera.eye,
                    perspective,
                    2.0 * half / sampling.height,
                    (sampling.width - 1.0) / 2.0,
                    (sampling.height - 1.0) / 2.0};
  View view;
  view.camera = camera;
  view.sampling = sampling;
  view.depth = fit_depth(scene, tree, frame, sampling);
  for (const facet::Plane& plane : scene.planes.planes()) {
    view.planes.push_back(make_screen_plane(frame, view.depth, sampling, to_eye(frame, plane, scene.planes.centre())));
  }
  for (const facet::Convex& solid : scene.solids)
    view.extents.push_back(make_extent(solid, frame, view.depth, sampling));
  const double far_step = (view.depth.far - view.depth.near) / isa::depth_steps(sampling.z_bits);
  view.depth_step = perspective ? far_step * view.depth.far / view.depth.near : far_step;
  return view;
}

}  // namespace csgsim::view
