#include "host/view/screen_quadric.h"

#include <rapidcheck.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "host/facet/geometry.h"
#include "host/view/projection.h"
#include "hw/isa/depth_scale.h"
#include "tests/support/test.h"
#include "tests/unit/view/held.h"
#include "tests/unit/view/quadric_subject.h"

using namespace csgsim;
using namespace csgsim::test;

namespace {

enum class Around : std::uint8_t { all_in, all_out, both };

/// Samples the shape around a place (column, row and depth) within `reach`, at `steps` places each way, finer in depth.
Around look_around(const Subject& subject, const view::View& view, const glm::dvec3& place, const glm::dvec3& reach,
                   int steps) {
  bool is_in_somewhere = false;
  bool is_out_somewhere = false;
  for (int i = -steps; i <= steps; ++i) {
    for (int j = -steps; j <= steps; ++j) {
      const Met met = meet(subject, place.x + reach.x * i / steps, place.y + reach.y * j / steps);
      for (int k = -2 * steps; k <= 2 * steps; ++k) {
        const Real distance = distance_at(view, place.z + reach.z * k / (2 * steps));
        // Orthographic views include places behind the eye.
        const bool is_seen = distance > 0 || !view.depth.perspective;
        const bool is_here = is_in(subject, met, distance) && is_seen;
        (is_here ? is_in_somewhere : is_out_somewhere) = true;
        if (is_in_somewhere && is_out_somewhere) return Around::both;
      }
    }
  }
  return is_in_somewhere ? Around::all_in : Around::all_out;
}

}  // namespace

TEST_CASE("a quadric's integer tests match the shape up to rounding from every viewpoint") {
  std::array<int, 4> roles{};
  int ins = 0;
  int unfit = 0;
  for (int round = 0; round < 8; ++round) {
    CHECK(rc::check([&] {
      const Subject subject = random_subject();
      const facet::Geometry scene = facet::make_geometry(subject.tree, exact());
      const view::View view = view::make_view(scene, subject.tree, subject.camera, subject.sampling);
      const view::ScreenQuadric& quadric = view.quadrics[0];
      const view::Extent& extent = view.extents[0];
      unfit += quadric.kind == view::ScreenQuadricKind::unfit ? 1 : 0;
      if (quadric.kind == view::ScreenQuadricKind::unfit || !representable(view) || quadric.pixels.empty()) return;
      ++roles[static_cast<std::size_t>(view::role_of(quadric, scene.solids[0].quadrics[0]))];
      const std::int64_t top = (std::int64_t{1} << subject.sampling.z_bits) - 1;
      const double unit = std::ldexp(1.0, static_cast<int>(quadric.unit));
      const double step = quadric.middle_error + 2.0 + unit * (1.0 + std::sqrt(quadric.discriminant_error));
      for (int i = 0; i < 40; ++i) {
        const std::int32_t x = *rc::gen::inRange(quadric.pixels.x0, quadric.pixels.x1 + 1);
        const std::int32_t y = *rc::gen::inRange(quadric.pixels.y0, quadric.pixels.y1 + 1);
        const std::int64_t z = *rc::gen::inRange<std::int64_t>(1, top - 2);
        const bool by_integers = test::is_held(view, scene.solids[0], x, y, z);
        // The neighbourhood within rounding is all inside or all outside, or else too close to decide.
        const double sideways = 2.0 * subject.sampling.edge_on_fraction + 0.02;
        const Around around = look_around(subject, view, {x, y, static_cast<double>(z)}, {sideways, sideways, step}, 1);
        if (around != (by_integers ? Around::all_out : Around::all_in)) {
          ins += around == Around::all_in ? 1 : 0;
        } else {
          // Features thinner than the sampling may be missed between samples.
          constexpr int close = 20;
          RC_ASSERT(look_around(subject, view, {x, y, static_cast<double>(z)}, {sideways, sideways, step}, close) ==
                    Around::both);
        }
        if (by_integers && z >= 1) {
          // Outside its own rectangle the shape is empty by rule; within it the extent contains it.
          RC_ASSERT(x >= extent.pixels.x0);
          RC_ASSERT(x <= extent.pixels.x1);
          RC_ASSERT(y >= extent.pixels.y0);
          RC_ASSERT(y <= extent.pixels.y1);
          RC_ASSERT(z >= extent.z_low);
          RC_ASSERT(z <= extent.z_high);
        }
      }
    }));
  }
  MESSAGE("roles ", roles[0], " ", roles[1], " ", roles[2], " ", roles[3], ", unfit ", unfit, ", surely in ", ins);
  CHECK((!testing::draws_usual_cases() || roles[0] > 100));
  CHECK((!testing::draws_usual_cases() || roles[1] > 10));
  CHECK((!testing::draws_usual_cases() || ins > 100));
}

TEST_CASE("a cylinder seen along its axis or at a tiny slant becomes an edge test") {
  for (const double slant : {0.0, 1e-7}) {
    const model::Tree tree = single(model::Cylinder{4, 10, 10, false, {}}, glm::dmat4(1.0));
    const facet::Geometry scene = facet::make_geometry(tree, exact());
    view::Sampling sampling;
    sampling.width = sampling.height = 64;
    // 200 tan(11.25 degrees) / 64 model units per pixel: the axis is at column and row 31.5.
    const view::Camera camera{{slant * 100, 0, 100}, {0, 0, 0}, view::Projection::orthographic};
    const view::View view = view::make_view(scene, tree, camera, sampling);
    REQUIRE(view.quadrics[0].kind == view::ScreenQuadricKind::edge);
    const double pixel = view::pixel_size(camera, 64, 100);
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 64; ++x) {
        const double from_edge = std::hypot(x - 31.5, y - 31.5) * pixel - 10.0;
        if (std::abs(from_edge) < 0.02 * pixel) continue;
        CHECK((view::value_at(view.quadrics[0].discriminant, x, y) >= 0) == (from_edge < 0.0));
      }
    }
    CHECK(view.extents[0].pixels == view::PixelRect{16, 16, 47, 47});
  }
}

TEST_CASE("a sheared cylinder seen from its side never becomes an edge test") {
  int seen = 0;
  for (int i = 0; i < 343; ++i) {
    const glm::dvec3 other(i % 7 - 3, i / 7 % 7 - 3, i / 49 - 3);
    for (const glm::dvec3& axis : {glm::dvec3(1, 1, 1), {1, 0, 2}, {3, -1, 2}, {1, -2, 0}}) {
      const glm::dvec3 across = glm::cross(axis, other);
      if (across == glm::dvec3(0)) continue;
      glm::dmat4 place(1.0);
      place[0] = glm::dvec4(1, 0, 1, 0);
      place[1] = glm::dvec4(1, 3, 0, 0);
      place[2] = glm::dvec4(axis, 0);
      const model::Tree tree = single(model::Cylinder{6, 3, 3, true, {}}, place);
      const facet::Geometry scene = facet::make_geometry(tree, exact());
      view::Sampling sampling;
      sampling.width = 24;
      sampling.height = 16;
      const view::Camera camera{glm::normalize(across) * 48.0, {0, 0, 0}, view::Projection::orthographic};
      CHECK(view::make_view(scene, tree, camera, sampling).quadrics[0].kind != view::ScreenQuadricKind::edge);
      ++seen;
    }
  }
  CHECK((!testing::draws_usual_cases() || seen > 1000));
}

TEST_CASE("a cylinder slanted by pixels is drawn with roots to within an edge's width") {
  const model::Tree tree = single(model::Cylinder{4, 10, 10, false, {}}, glm::dmat4(1.0));
  const facet::Geometry scene = facet::make_geometry(tree, exact());
  view::Sampling sampling;
  int coarse = 0;
  for (const double slant : {1e-4, 1e-3, 1e-2, 0.1, 1.0}) {
    const view::Camera camera{{slant * 100, 0, 100}, {0, 0, 0}, view::Projection::orthographic};
    const view::View view = view::make_view(scene, tree, camera, sampling);
    const view::ScreenQuadric& quadric = view.quadrics[0];
    if (quadric.kind == view::ScreenQuadricKind::edge) continue;
    REQUIRE(quadric.kind == view::ScreenQuadricKind::roots);
    const double slope = std::ldexp(std::hypot(quadric.middle.a, quadric.middle.b), -12);
    CHECK(std::ldexp(1.0, static_cast<int>(quadric.unit)) <= std::max(1.0, slope * sampling.edge_on_fraction));
    const view::RootRanges ranges = view::ranges_over(quadric, 12, quadric.pixels);
    if (quadric.unit > 0) CHECK(ranges.max_root < std::int64_t{1} << 23U);
    coarse += quadric.unit > 0 ? 1 : 0;
  }
  CHECK(coarse > 0);
}

TEST_CASE("a cone with its apex at the eye is an edge test unless both nappes are visible") {
  view::Sampling sampling;
  sampling.width = sampling.height = 64;
  glm::dmat4 place(1.0);
  const model::Tree slender = single(model::Cylinder{10, 0, 1, false, {}}, place);
  const view::Camera up{{0, 0, 0}, {0, 0, 5}, view::Projection::perspective};
  const view::View view = view::make_view(facet::make_geometry(slender, exact()), slender, up, sampling);
  REQUIRE(view.quadrics[0].kind == view::ScreenQuadricKind::edge);
  const double tangent = 2.0 * view::half_height_per_distance() / 64;
  for (int x = 0; x < 64; ++x) {
    const double from_edge = std::abs(x - 31.5) * tangent - 0.1;
    if (std::abs(from_edge) < 0.02 * tangent) continue;
    CHECK((view::value_at(view.quadrics[0].discriminant, x, 31) >= 0) == (std::hypot(x - 31.5, 0.5) * tangent < 0.1));
  }
  model::Tree flat = single(model::Cylinder{0.01, 0, 10, false, {}}, place);
  flat.primitives.push_back({model::Cylinder{0.01, 0, 10, false, {}}, scaling({1, 1, -1}), std::nullopt, {}});
  flat.nodes.push_back({true, model::Operator::unite, 1, {}});
  flat.nodes.push_back({false, model::Operator::unite, model::no_index, {0, 1}});
  flat.root = 2;
  const view::Camera along{{0, 0, 0}, {5, 0, 0}, view::Projection::perspective};
  const view::View both = view::make_view(facet::make_geometry(flat, exact()), flat, along, sampling);
  REQUIRE(both.quadrics.size() == 1);
  CHECK(both.quadrics[0].kind == view::ScreenQuadricKind::unfit);
}

TEST_CASE("an eye on a quadric and a cone seen along a generator are not representable") {
  view::Sampling sampling;
  sampling.width = sampling.height = 64;
  const model::Tree ball = single(model::Sphere{1, {}}, glm::dmat4(1.0));
  const view::Camera on{{1, 0, 0}, {0, 0, 0}, view::Projection::perspective};
  CHECK(view::make_view(facet::make_geometry(ball, exact()), ball, on, sampling).quadrics[0].kind ==
        view::ScreenQuadricKind::unfit);
  const model::Tree cone = single(model::Cylinder{1, 0, 1, false, {}}, glm::dmat4(1.0));
  const view::Camera along{{-5, 0, -5}, {0, 0, 0}, view::Projection::orthographic};
  CHECK(view::make_view(facet::make_geometry(cone, exact()), cone, along, sampling).quadrics[0].kind ==
        view::ScreenQuadricKind::unfit);
}

TEST_CASE("a sphere's depth range and pixels are exact and not those of a larger hull") {
  const model::Tree tree = single(model::Sphere{10, {}}, glm::dmat4(1.0));
  const facet::Geometry scene = facet::make_geometry(tree, exact());
  const view::Camera camera{{0, 0, 100}, {0, 0, 0}, view::Projection::orthographic};
  view::Sampling sampling;
  const view::View view = view::make_view(scene, tree, camera, sampling);
  CHECK(view.depth.near == doctest::Approx(90.0).epsilon(1e-12));
  CHECK(view.depth.far == doctest::Approx(110.0).epsilon(1e-12));
  const double radius = 10.0 / view::pixel_size(camera, 512, 100);
  const auto first = static_cast<std::int32_t>(std::ceil(255.5 - radius));
  CHECK(view.extents[0].pixels == view::PixelRect{first, first, 511 - first, 511 - first});
}

TEST_CASE("the depths of an extent include the back of the solid") {
  const model::Tree tree = single(model::Sphere{3, {}}, glm::dmat4(1.0));
  const facet::Geometry scene = facet::make_geometry(tree, exact());
  for (const auto projection : {view::Projection::orthographic, view::Projection::perspective}) {
    view::Sampling sampling;
    sampling.width = sampling.height = 24;
    sampling.z_bits = 5;
    const view::View view = view::make_view(scene, tree, {{1, 2, 16}, {0, 0, 0}, projection}, sampling);
    const view::Extent& extent = view.extents[0];
    const view::RootRanges ranges = view::ranges_over(view.quadrics[0], sampling.fraction_bits, extent.pixels);
    CHECK(ranges.max_root > 10);
    CHECK(extent.z_high >= ranges.far.high);
    CHECK(extent.z_low <= std::max<std::int64_t>(ranges.near.low, 0));
  }
}

TEST_CASE("equal surfaces of different solids have the same integers") {
  model::Tree tree = single(model::Cylinder{4, 5, 5, false, {}}, rotated_by_a_third());
  tree.primitives.push_back({model::Cylinder{9, 5, 5, true, {}}, rotated_by_a_third() * turn_about(2, 1.0), {}, {}});
  tree.nodes.push_back({true, model::Operator::unite, 1, {}});
  tree.nodes.push_back({false, model::Operator::subtract, model::no_index, {0, 1}});
  tree.root = 2;
  const facet::Geometry scene = facet::make_geometry(tree, exact());
  const view::View view = view::make_view(scene, tree, view::default_camera(scene.box, 512, 512), {});
  CHECK(view.quadrics.size() == 1);
  CHECK(view.quadrics[0].kind == view::ScreenQuadricKind::roots);
  CHECK(scene.solids[0].quadrics == scene.solids[1].quadrics);
}
