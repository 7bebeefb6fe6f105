#include <rapidcheck.h>

#include "host/facet/geometry.h"
#include "host/view/camera.h"
#include "host/view/fixed_point.h"
#include "host/view/projection.h"
#include "hw/isa/depth_scale.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

double real(int low, int high) { return *rc::gen::inRange(low * 1000, high * 1000) / 1000.0; }

model::Tree box_at(const glm::dvec3& corner, const glm::dvec3& size) {
  model::Tree tree;
  glm::dmat4 place(1.0);
  place[3] = glm::dvec4(corner, 1.0);
  tree.primitives.push_back({model::Cube{size, false}, place, std::nullopt, {}});
  tree.nodes.push_back({true, model::Operator::unite, 0, {}});
  tree.root = 0;
  return tree;
}

/// Distance along the view axis at which the ray of a pixel centre meets a plane.
double meet(const view::Camera& camera, const view::Sampling& sampling, const facet::Plane& plane,
            const glm::dvec3& centre, int x, int y) {
  const view::Basis axes = view::basis(camera);
  const double tangent = view::half_height_per_distance();
  const bool perspective = camera.projection == view::Projection::perspective;
  const double scale = 2.0 * tangent * (perspective ? 1.0 : glm::length(camera.centre - camera.eye)) / sampling.height;
  const double right = (x + 0.5 - sampling.width / 2.0) * scale;
  const double up = (sampling.height / 2.0 - y - 0.5) * scale;
  const glm::dvec3 start = perspective ? camera.eye : camera.eye + right * axes.right + up * axes.up;
  const glm::dvec3 direction = perspective ? axes.forward + right * axes.right + up * axes.up : axes.forward;
  return -(glm::dot(plane.normal, start - centre) + plane.offset) / glm::dot(plane.normal, direction);
}

}  // namespace

TEST_CASE("to_fixed() rounds to the nearest fixed-point integer and halves away from zero") {
  CHECK(view::to_fixed(1.0, 12) == 4096);
  CHECK(view::to_fixed(-0.5, 1) == -1);
  CHECK(view::to_fixed(0.49, 0) == 0);
  CHECK(view::to_fixed(-2.5, 0) == -3);
}

TEST_CASE("to_fixed() has no result for a number that fits no integer") {
  CHECK_FALSE(view::to_fixed(1e30, 12).has_value());
  CHECK_FALSE(view::to_fixed(std::numeric_limits<double>::infinity(), 0).has_value());
  CHECK_FALSE(view::to_fixed(std::nan(""), 0).has_value());
}

TEST_CASE("the range of a plane over a rectangle is the extremes at the corners") {
  CHECK(rc::check([] {
    const view::FixedLinear linear{*rc::gen::inRange(-50, 50), *rc::gen::inRange(-50, 50),
                                   *rc::gen::inRange(-500, 500)};
    const view::PixelRect rect{2, 3, 2 + *rc::gen::inRange(0, 9), 3 + *rc::gen::inRange(0, 9)};
    std::int64_t low = std::numeric_limits<std::int64_t>::max();
    std::int64_t high = std::numeric_limits<std::int64_t>::min();
    for (int y = rect.y0; y <= rect.y1; ++y) {
      for (int x = rect.x0; x <= rect.x1; ++x) {
        low = std::min(low, linear.a * x + linear.b * y + linear.c);
        high = std::max(high, linear.a * x + linear.b * y + linear.c);
      }
    }
    const view::Range range = view::range_over(linear, rect);
    RC_ASSERT(range.low == low);
    RC_ASSERT(range.high == high);
  }));
}

TEST_CASE("a camera's axes are right and up and forward as in OpenSCAD") {
  const view::Basis from_front = view::basis({{0, -10, 0}, {0, 0, 0}, view::Projection::orthographic});
  CHECK(from_front.right == glm::dvec3(1, 0, 0));
  CHECK(from_front.up == glm::dvec3(0, 0, 1));
  CHECK(from_front.forward == glm::dvec3(0, 1, 0));
  const view::Basis from_above = view::basis({{0, 0, 10}, {0, 0, 0}, view::Projection::orthographic});
  CHECK(from_above.right == glm::dvec3(1, 0, 0));
  CHECK(from_above.up == glm::dvec3(0, 1, 0));
}

TEST_CASE("the default view is OpenSCAD's orthographic one tilted by 55 and 25 degrees") {
  const view::Camera camera = view::default_camera({{-1, 2, 3}, {5, 4, 9}}, 640, 480);
  CHECK(camera.projection == view::Projection::orthographic);
  const glm::dvec3 toward_eye = glm::normalize(camera.eye - camera.centre);
  const double degree = std::acos(-1.0) / 180.0;
  CHECK(std::acos(toward_eye.z) / degree == doctest::Approx(55.0).epsilon(1e-9));
  CHECK(std::atan2(toward_eye.x, -toward_eye.y) / degree == doctest::Approx(25.0).epsilon(1e-9));
}

TEST_CASE("a camera without a direction is rejected") {
  CHECK_THROWS_AS(view::basis({{1, 2, 3}, {1, 2, 3}, view::Projection::orthographic}), InputError);
  CHECK_THROWS_AS(view::basis({{1, 2, std::nan("")}, {0, 0, 0}, view::Projection::orthographic}), InputError);
}

TEST_CASE("view-all shows the whole bounding sphere in both projections") {
  const facet::Box box{{-1, 2, 3}, {5, 4, 9}};
  const view::Camera camera = view::view_all({{10, -20, 30}, {0, 0, 0}, view::Projection::perspective}, box, 512, 512);
  const double radius = glm::length(box.high - box.low) / 2.0;
  CHECK(camera.centre == box.centre());
  CHECK(std::asin(radius / glm::length(camera.eye - camera.centre)) ==
        doctest::Approx(std::atan(view::half_height_per_distance())));
  CHECK(view::half_height(camera) >= radius);
}

TEST_CASE("surface planes meet pixel rays within a depth step and slope rounding") {
  CHECK(rc::check([] {
    const model::Tree tree = box_at({real(-3, 3), real(-3, 3), real(-3, 3)}, {real(1, 5), real(1, 5), real(1, 5)});
    const facet::Geometry scene = facet::make_geometry(tree);
    const auto projection = *rc::gen::element(view::Projection::orthographic, view::Projection::perspective);
    const view::Camera camera{
        {real(20, 60), real(-60, -20), real(-40, 40)}, {real(-3, 3), real(-3, 3), real(-3, 3)}, projection};
    view::Sampling sampling;
    sampling.width = static_cast<std::uint32_t>(*rc::gen::inRange(3, 300));
    sampling.height = static_cast<std::uint32_t>(*rc::gen::inRange(3, 300));
    const view::View view = view::make_view(scene, tree, camera, sampling);
    const int x = *rc::gen::inRange(0, static_cast<int>(sampling.width));
    const int y = *rc::gen::inRange(0, static_cast<int>(sampling.height));
    // Half an ulp of the coefficients per pixel from the middle, and the step that floor removes.
    const double bound = 1.0 + (2.0 + sampling.width / 2.0 + sampling.height / 2.0) * std::ldexp(0.5, -12);
    for (std::size_t i = 0; i < view.planes.size(); ++i) {
      const view::ScreenPlane& plane = view.planes[i];
      if (plane.kind == view::PlaneKind::edge) continue;
      const double distance = meet(camera, sampling, scene.planes.planes()[i], scene.planes.centre(), x, y);
      const double expected = isa::depth_of(view.depth, sampling.z_bits, distance);
      const std::int64_t f = (plane.linear.a * x + plane.linear.b * y + plane.linear.c) >> sampling.fraction_bits;
      RC_ASSERT(std::abs(expected - 0.5 - static_cast<double>(f)) <= bound + 1e-6 * std::abs(expected));
    }
  }));
}

TEST_CASE("view-all moves away for a tall picture and not closer for a wide one") {
  const facet::Box box{{-1, -1, -1}, {1, 1, 1}};
  const view::Camera from{{10, -20, 30}, {0, 0, 0}, view::Projection::perspective};
  const auto distance = [&](std::uint32_t width, std::uint32_t height) {
    const view::Camera camera = view::view_all(from, box, width, height);
    return glm::length(camera.eye - camera.centre);
  };
  CHECK(distance(400, 100) == distance(100, 100));
  // Half the width must contain the bounding sphere.
  CHECK(view::half_height(view::view_all(from, box, 100, 400)) / 4.0 >= std::sqrt(3.0));
  CHECK(distance(100, 400) > 3.9 * distance(100, 100));
}

TEST_CASE("a near plane behind the whole model is rejected") {
  const model::Tree tree = box_at({0, 0, 0}, {1, 1, 1});
  const facet::Geometry scene = facet::make_geometry(tree);
  const auto see = [&](double near, view::Projection projection) {
    view::Sampling sampling;
    sampling.near = near;
    return view::make_view(scene, tree, {{0, -9, 3}, {0, 0, 0}, projection}, sampling);
  };
  CHECK_NOTHROW(see(0.01, view::Projection::perspective));
  CHECK_THROWS_AS(see(100, view::Projection::perspective), InputError);
}

TEST_CASE("depth_of() and distance_of() are inverse to each other") {
  for (const isa::DepthScale& scale : {isa::DepthScale{false, -3, 17}, isa::DepthScale{true, 0.5, 128}}) {
    for (const std::uint32_t step : {1U, 2U, 77U, 4000U, 65533U}) {
      CHECK(isa::depth_of(scale, 16, isa::distance_of(scale, 16, step)) == doctest::Approx(step).epsilon(1e-9));
    }
    CHECK(isa::distance_of(scale, 16, 1) == doctest::Approx(scale.near));
    CHECK(isa::distance_of(scale, 16, 65533) == doctest::Approx(scale.far));
    CHECK(std::isinf(isa::distance_of(scale, 16, 65535)));
  }
}

TEST_CASE("faces seen edge-on become edge tests with a positive leading coefficient") {
  const model::Tree tree = box_at({0, 0, 0}, {2, 2, 2});
  const facet::Geometry scene = facet::make_geometry(tree);
  const view::View view = view::make_view(scene, tree, {{0, -9, 0}, {0, 0, 0}, view::Projection::orthographic}, {});
  int edges = 0;
  for (const view::ScreenPlane& plane : view.planes) {
    if (plane.kind != view::PlaneKind::edge) continue;
    ++edges;
    CHECK((plane.linear.a > 0 || (plane.linear.a == 0 && plane.linear.b > 0)));
  }
  CHECK(edges == 4);
}

TEST_CASE("rounding hardly enlarges a thick solid's box but greatly enlarges a thin sheet's") {
  const view::Camera camera{{0, -40, 0}, {0, 0, 0}, view::Projection::orthographic};
  const auto extent_of = [&](const model::Tree& tree, const view::Sampling& sampling) {
    return view::make_view(facet::make_geometry(tree), tree, camera, sampling).extents[0];
  };
  const view::Extent thick = extent_of(box_at({-4, -4, -4}, {8, 8, 8}), {});
  for (int axis = 0; axis < 3; ++axis) {
    CHECK(thick.box.low[axis] <= -4.0);
    CHECK(thick.box.low[axis] > -4.001);
    CHECK(thick.box.high[axis] >= 4.0);
    CHECK(thick.box.high[axis] < 4.001);
  }
  view::Sampling coarse;
  coarse.z_bits = 6;
  coarse.fraction_bits = 0;
  CHECK(extent_of(box_at({-4, -4, -4}, {8, 8, 8}), coarse).box.high.x > 8.0);
  // A sheet seen straight on, much thinner than a depth step.
  const view::Extent thin = extent_of(box_at({-4, 0, -4}, {8, 1e-9, 8}), coarse);
  CHECK(thin.box.high.x > 100.0);
  CHECK(thin.z_low <= 1);
  CHECK(thin.z_high >= 1);
  CHECK(thin.z_high < 8);
}

TEST_CASE("the extent of a solid cut by the near plane starts at its cap at depth 0") {
  model::Tree tree = box_at({-5, 19, -5}, {10, 1, 10});
  // A pyramid whose tip points away from the eye: depths up to 3.4 of 64 remain of it.
  const glm::dmat4 away(glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 0, -1, 0), glm::dvec4(0, 1, 0, 0),
                        glm::dvec4(0, 9, 0, 1));
  tree.primitives.push_back({model::Cylinder{1.2, 2, 0, false, {4, 12, 2}}, away, std::nullopt, {}});
  tree.nodes = {{true, model::Operator::unite, 0, {}},
                {true, model::Operator::unite, 1, {}},
                {false, model::Operator::unite, model::no_index, {0, 1}}};
  tree.root = 2;
  view::Sampling coarse;
  coarse.z_bits = 6;
  coarse.near = 10;
  const view::View view =
      view::make_view(facet::make_geometry(tree), tree, {{0, 0, 0}, {0, 1, 0}, view::Projection::perspective}, coarse);
  const view::Extent& extent = view.extents[1];
  CHECK(extent.cut_by_near);
  CHECK(extent.z_low == 0);
  REQUIRE_FALSE(extent.corners.empty());
  double nearest = extent.corners.front().z;
  for (const glm::dvec3& corner : extent.corners) nearest = std::min(nearest, corner.z);
  CHECK(std::abs(nearest) < 1e-9);
}

TEST_CASE("the depth step of a view is its coarsest step in model units") {
  const model::Tree tree = box_at({-5, -5, -5}, {10, 10, 10});
  const facet::Geometry scene = facet::make_geometry(tree);
  for (const auto projection : {view::Projection::orthographic, view::Projection::perspective}) {
    view::Sampling sampling;
    sampling.z_bits = 12;
    const view::View view = view::make_view(scene, tree, {{0, -40, 10}, {0, 0, 0}, projection}, sampling);
    double coarsest = 0;
    for (std::uint32_t step = 1; step < (1U << 12U) - 3; ++step) {
      coarsest =
          std::max(coarsest, isa::distance_of(view.depth, 12, step + 1) - isa::distance_of(view.depth, 12, step));
    }
    CHECK(view.depth_step == doctest::Approx(coarsest).epsilon(1e-3));
  }
}

TEST_CASE("a model behind the eye is absent from a perspective picture") {
  const model::Tree tree = box_at({0, 0, 0}, {1, 1, 1});
  const facet::Geometry scene = facet::make_geometry(tree);
  const view::View view = view::make_view(scene, tree, {{0, 9, 0}, {0, 19, 0}, view::Projection::perspective}, {});
  CHECK(view.extents[0].empty());
}

TEST_CASE("an eye inside the model puts the near plane in front of the eye") {
  const model::Tree tree = box_at({-5, -5, -5}, {10, 10, 10});
  const facet::Geometry scene = facet::make_geometry(tree);
  const view::View view = view::make_view(scene, tree, {{0, 0, 0}, {0, 1, 0}, view::Projection::perspective}, {});
  CHECK(view.depth.far == doctest::Approx(5));
  CHECK(view.depth.near == doctest::Approx(5.0 / 256));
  view::Sampling sampling;
  sampling.near = 0.5;
  CHECK(view::make_view(scene, tree, {{0, 0, 0}, {0, 1, 0}, view::Projection::perspective}, sampling).depth.near ==
        0.5);
}

TEST_CASE("a sampling with an invalid size or number of bits is rejected") {
  const model::Tree tree = box_at({0, 0, 0}, {1, 1, 1});
  const facet::Geometry scene = facet::make_geometry(tree);
  const view::Camera camera{{0, -9, 3}, {0, 0, 0}, view::Projection::orthographic};
  const auto with = [](auto change) {
    view::Sampling sampling;
    change(sampling);
    return sampling;
  };
  CHECK_THROWS_AS(view::make_view(scene, tree, camera, with([](view::Sampling& s) { s.width = 0; })), InputError);
  CHECK_THROWS_AS(view::make_view(scene, tree, camera, with([](view::Sampling& s) { s.height = 1U << 20U; })),
                  InputError);
  CHECK_THROWS_AS(view::make_view(scene, tree, camera, with([](view::Sampling& s) { s.z_bits = 3; })), InputError);
  CHECK_THROWS_AS(view::make_view(scene, tree, camera, with([](view::Sampling& s) { s.z_bits = 31; })), InputError);
  CHECK_THROWS_AS(view::make_view(scene, tree, camera, with([](view::Sampling& s) { s.fraction_bits = 21; })),
                  InputError);
  CHECK_THROWS_AS(view::make_view(scene, tree, camera, with([](view::Sampling& s) { s.edge_on_fraction = 0; })),
                  InputError);
  CHECK_THROWS_AS(view::make_view(scene, tree, camera, with([](view::Sampling& s) { s.edge_on_fraction = 1.25; })),
                  InputError);
  CHECK_NOTHROW(view::make_view(scene, tree, camera, with([](view::Sampling& s) { s.edge_on_fraction = 1; })));
  CHECK_THROWS_AS(view::make_view(scene, tree, camera, with([](view::Sampling& s) { s.near = -1; })), InputError);
}
