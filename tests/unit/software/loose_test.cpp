#include <glm/vec3.hpp>

#include "host/read/read.h"
#include "host/view/eye_space.h"
#include "hw/isa/depth_scale.h"
#include "sim/software/tracing/trace_scene.h"
#include "sim/software/tree/tree.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"
#include "tests/unit/software/scenes.h"

using namespace csgsim;
using testing::Scene;

namespace {

/// Distance from a convex polygon: exact next to an edge, underestimated by at most the root of two next to a corner.
double distance_to(const glm::dvec3& point, std::span<const glm::dvec3> corners) {
  const glm::dvec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
  const double height = glm::dot(normal, point - corners[0]);
  const glm::dvec3 foot = point - normal * height;
  double beside = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 out = glm::normalize(glm::cross(corners[(i + 1) % corners.size()] - corners[i], normal));
    beside = std::max(beside, glm::dot(out, foot - corners[i]));
  }
  return std::hypot(height, beside);
}

struct Found {
  std::uint64_t loose = 0;
  std::uint64_t tight = 0;
  std::uint64_t near_the_limit = 0;  ///< facets whose depth error is a quarter of the reach to twice the reach
  std::uint64_t before_near = 0;     ///< facets in front that are partly before the near plane
};

/// Depth errors of a facet at the pixels that it covers.
struct Off {
  double farthest = 0;
  bool is_before_near = false;  ///< true where rays enter before the near plane
};

Off off_place(const Scene& scene, const software::TraceScene& traced, const software::ScreenFacet& facet) {
  const view::EyeSpace eye = view::eye_space(scene.view.camera, scene.view.sampling);
  const double one = std::ldexp(1.0, static_cast<int>(scene.view.sampling.fraction_bits));
  const std::span<const glm::dvec3> corners = traced.facets().corners_of(facet.facet);
  Off off;
  for (std::int32_t y = facet.pixels.y0; y <= facet.pixels.y1; ++y) {
    for (std::int32_t x = facet.pixels.x0; x <= facet.pixels.x1; ++x) {
      const bool is_covered = std::ranges::all_of(
          traced.screen().bounds_of(facet), [&](const view::FixedLinear& bound) { return value_at(bound, x, y) >= 0; });
      if (!is_covered) continue;
      const double depth = static_cast<double>(value_at(facet.depth, x, y)) / one;
      off.is_before_near = off.is_before_near || (depth < 0 && !facet.leaves);
      if (depth < 0 || depth > traced.screen().farthest) continue;
      const double distance = isa::distance_at(scene.view.depth, scene.view.sampling.z_bits, depth);
      const glm::dvec3 place =
          eye.to_model(eye.from_picture({static_cast<double>(x), static_cast<double>(y), distance})) -
          scene.geometry.planes.centre();
      off.farthest = std::max(off.farthest, distance_to(place, corners));
    }
  }
  return off;
}

void check_loose(const Scene& scene, Found& found) {
  const software::Tree tree = software::make_tree(scene.tree, software::Shape::written);
  const software::TraceScene traced(scene.tree, scene.geometry, scene.view, tree);
  const double limit = traced.shapes().reach() / 2;
  for (std::uint32_t i = 0; i < traced.screen().facets.size(); ++i) {
    const software::ScreenFacet& facet = traced.screen().facets[i];
    if (facet.facet == software::ScreenFacet::near_cap) continue;
    const Off both = off_place(scene, traced, facet);
    const double off = both.farthest;
    const bool is_loose = traced.screen_of(facet.facet) != i;
    found.before_near += both.is_before_near ? 1U : 0U;
    if (both.is_before_near) {
      CHECK(is_loose);
      continue;
    }
    found.near_the_limit += off > limit / 2 && off < 4 * limit ? 1U : 0U;
    (is_loose ? found.loose : found.tight) += 1U;
    // The distance from a corner is underestimated by at most the root of two.
    if (off > 1.001 * limit) CHECK(is_loose);
    if (off * std::sqrt(2.0) < 0.999 * limit) CHECK(!is_loose);
  }
}

}  // namespace

TEST_CASE("a facet counts as loose exactly if its depth error exceeds half the cells' reach") {
  Found found;
  for (unsigned turn = 1; turn <= 12; ++turn) {
    for (const unsigned fraction_bits : {0U, 1U, 2U, 3U}) {
      for (const unsigned z_bits : {14U, 15U, 16U, 17U, 18U}) {
        CAPTURE(turn);
        CAPTURE(fraction_bits);
        CAPTURE(z_bits);
        view::Sampling sampling;
        sampling.width = 48;
        sampling.height = 32;
        sampling.z_bits = z_bits;
        sampling.fraction_bits = fraction_bits;
        const double angle = 0.1 * turn;
        const Scene scene = testing::make_scene(
            read::read_csg_text("cube(size=[9,7,5],center=true);", "block"),
            {{60 * std::cos(angle), 60 * std::sin(angle), 20 + turn}, {0, 0, 0}, view::Projection::orthographic},
            sampling);
        check_loose(scene, found);
      }
    }
  }
  MESSAGE(found.loose, " loose, ", found.tight, " not, ", found.near_the_limit, " near the limit");
  CHECK(found.loose > 100);
  CHECK(found.tight > 100);
  CHECK(found.near_the_limit > 50);
}
TEST_CASE("a facet displaced by perspective or crossing the near plane is loose") {
  Found found;
  for (unsigned turn = 1; turn <= 12; ++turn) {
    for (const double near : {0.0, 7.0, 9.0}) {
      for (const unsigned z_bits : {13U, 15U, 16U, 17U, 20U}) {
        CAPTURE(turn);
        CAPTURE(near);
        CAPTURE(z_bits);
        view::Sampling sampling;
        sampling.width = 48;
        sampling.height = 32;
        sampling.z_bits = z_bits;
        sampling.fraction_bits = turn % 4;
        // A small model entirely about one unit from the eye.
        const double size = turn % 3 == 0 ? 1.0 / 12 : 1;
        if (near > 0) sampling.near = near * size;
        const double angle = 0.1 * turn;
        const glm::dvec3 eye = glm::dvec3{12 * std::cos(angle), 12 * std::sin(angle), 4 + turn / 4.0} * size;
        const Scene scene = testing::make_scene(
            read::read_csg_text(fmt::format("cube(size=[{},{},{}],center=true);", 9 * size, 7 * size, 5 * size),
                                "block"),
            {eye, {0, 0, 0}, view::Projection::perspective}, sampling);
        check_loose(scene, found);
      }
    }
  }
  MESSAGE(found.loose, " loose, ", found.tight, " not, ", found.near_the_limit, " near the limit, ", found.before_near,
          " before the near plane");
  CHECK(found.loose > 50);
  CHECK(found.tight > 100);
  CHECK(found.near_the_limit > 20);
  CHECK(found.before_near > 20);
}
