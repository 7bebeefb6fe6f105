#include "tests/unit/judges/scenery.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "host/read/read.h"
#include "hw/isa/depth_scale.h"
#include "sim/judges/analytic.h"
#include "tests/oracle/tree_rules.h"

namespace csgsim::testing {

namespace {

Scenery make(const std::string& csg, const view::Camera& camera, Size size, double near, bool exact_curves) {
  facet::Faceting faceting;
  faceting.exact_curves = exact_curves;
  model::Tree tree = read::read_csg_text(csg, "test");
  facet::Geometry scene = facet::make_geometry(tree, faceting);
  return {std::move(tree), std::move(scene), camera, size.width, size.height, near};
}

isa::DepthScale depth_of(const Scenery& scenery) {
  return {scenery.camera.projection == view::Projection::perspective, scenery.near, 1000};
}

}  // namespace

Scenery make_scenery(const std::string& csg, const view::Camera& camera, Size size, double near) {
  return make(csg, camera, size, near, false);
}

Scenery make_curved_scenery(const std::string& csg, const view::Camera& camera, Size size, double near) {
  return make(csg, camera, size, near, true);
}

judges::Truth exact(const Scenery& scenery) {
  return judges::exact_truth(scenery.tree, scenery.scene, scenery.camera, scenery.width, scenery.height,
                             depth_of(scenery));
}

judges::Truth analytic(const Scenery& scenery) {
  return judges::analytic_truth(scenery.tree, {.min_round_sides = 0}, scenery.camera, scenery.width, scenery.height,
                                depth_of(scenery));
}

double straight_distance(std::uint32_t height) { return height / 2.0 / view::half_height_per_distance(); }

view::Camera straight_camera(std::uint32_t height, view::Projection projection) {
  return {{0, -straight_distance(height), 0}, {0, 0, 0}, projection};
}

std::string owners(const judges::Truth& truth) {
  std::string picture;
  for (std::size_t i = 0; i < truth.owner.size(); ++i) {
    picture += truth.owner[i] == judges::nothing ? '.' : static_cast<char>('0' + truth.owner[i]);
    if ((i + 1) % truth.width == 0) picture += '\n';
  }
  return picture;
}

double distance_in_doubles(const Scenery& scenery, std::uint32_t column, std::uint32_t row, std::uint32_t owner) {
  const view::Camera& camera = scenery.camera;
  const view::Basis basis = view::basis(camera);
  const bool perspective = camera.projection == view::Projection::perspective;
  const double pixel = 2.0 * view::half_height_per_distance() / scenery.height *
                       (perspective ? 1.0 : glm::length(camera.centre - camera.eye));
  const glm::dvec3 aside =
      pixel * ((column - (scenery.width - 1.0) / 2.0) * basis.right - (row - (scenery.height - 1.0) / 2.0) * basis.up);
  const glm::dvec3 origin = camera.eye + (perspective ? glm::dvec3(0) : aside) - scenery.scene.planes.centre();
  const glm::dvec3 direction = basis.forward + (perspective ? aside : glm::dvec3(0));
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double front = perspective ? scenery.near : -infinity;
  double back = infinity;
  for (const facet::Halfspace& halfspace : scenery.scene.solids[owner].halfspaces) {
    const facet::Plane& plane = scenery.scene.planes.planes()[halfspace.plane];
    const double slope = glm::dot(plane.normal, direction) * (halfspace.positive ? 1.0 : -1.0);
    const double t = -(glm::dot(plane.normal, origin) + plane.offset) / glm::dot(plane.normal, direction);
    if (slope < 0.0) front = std::max(front, t);
    if (slope > 0.0) back = std::min(back, t);
  }
  return TreeRules(scenery.tree).is_subtracted(owner) ? back : front;
}

}  // namespace csgsim::testing
