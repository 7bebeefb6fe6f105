#include <rapidcheck.h>

#include "host/solids/check.h"
#include "host/swept/mesh.h"
#include "tests/support/test.h"
#include "tests/unit/swept/support.h"

using namespace csgsim;
using namespace csgsim::swept_test;
using namespace swept;

namespace {

constexpr double pi = std::numbers::pi;

/// A closed cubic through a circle about the origin up to some millionths: its control points are further out
/// accordingly.
Curve circle(double radius, std::size_t points, bool in_xz = false) {
  Curve curve{3, true, {}};
  const double out = radius * 3 / (2 + std::cos(2 * pi / static_cast<double>(points)));
  for (std::size_t i = 0; i < points; ++i) {
    const double angle = 2 * pi * static_cast<double>(i) / static_cast<double>(points);
    const double x = out * std::cos(angle);
    const double y = out * std::sin(angle);
    curve.points.push_back(in_xz ? glm::dvec3{x, 0, y} : glm::dvec3{x, y, 0});
  }
  return curve;
}

Curve square(double half) {
  return {1, true, {{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}}};
}

Curve line(const glm::dvec3& from, const glm::dvec3& to) { return {1, false, {from, to}}; }

std::string validation_error(const swept::SweptSolid& solid) {
  if (std::string open = open_edge(solid.mesh.faces); !open.empty()) return open;
  const solids::CheckedMesh checked = solids::check(solid.mesh, 1e-9);
  return checked.defect ? checked.defect->what : "";
}

double volume_of(const Sweep& sweep, double tolerance) {
  const swept::SweptSolid solid = swept::make_swept_solid(sweep, {tolerance});
  CHECK(validation_error(solid) == "");
  return volume(solid.mesh);
}

}  // namespace

TEST_CASE("a square swept along a line is a block for either direction of the contour") {
  Sweep sweep{square(2), line({0, 0, 1}, {0, 0, 6})};
  CHECK(volume_of(sweep, 0.1) == doctest::Approx(80));
  std::ranges::reverse(sweep.contour.points);
  CHECK(volume_of(sweep, 0.1) == doctest::Approx(80));
  CHECK(swept::make_swept_solid(sweep, {0.1}).mesh.faces.size() == 6);
}

TEST_CASE("a contour along the z axis keeps its drawn orientation: u is x and v is y") {
  const Sweep sweep{{1, true, {{1, 0, 0}, {5, 0, 0}, {5, 2, 0}}}, line({0, 0, 0}, {0, 0, 1})};
  const swept::SweptSolid solid = swept::make_swept_solid(sweep, {0.1});
  const auto has = [&](const glm::dvec3& point) {
    return std::ranges::any_of(solid.mesh.points, [&](const auto& one) { return glm::distance(one, point) < 1e-12; });
  };
  CHECK(has({1, 0, 0}));
  CHECK(has({5, 2, 1}));
  CHECK(has({5, 0, 0}));
}

TEST_CASE("a sweep's v points backwards along the rising y axis and otherwise forwards") {
  for (const double up : {1.0, -1.0}) {
    const Sweep sweep{{1, true, {{0, 0, 0}, {1, 0, 0}, {0, 3, 0}}}, line({0, 0, 0}, {0, up, 0})};
    const swept::SweptSolid solid = swept::make_swept_solid(sweep, {0.1});
    const bool found = std::ranges::any_of(solid.mesh.points, [&](const auto& one) {
      return glm::distance(one, {0, 0, -3 * up}) < 1e-12;
    });
    CHECK(found);
  }
}

TEST_CASE("a scale that ends at 0 makes a cone with a third of the volume and one tip") {
  Sweep sweep{square(3), line({0, 0, 0}, {0, 0, 5})};
  sweep.scale = {1, false, {{1, 1, 0}, {0, 0, 0}}};
  CHECK(volume_of(sweep, 0.1) == doctest::Approx(60));
  CHECK(swept::make_swept_solid(sweep, {0.1}).mesh.points.size() == 5);
  sweep.contour = circle(3, 24);
  CHECK(volume_of(sweep, 0.001) == doctest::Approx(pi * 9 * 5 / 3).epsilon(0.001));
}

TEST_CASE("a twisted square keeps its volume") {
  Sweep sweep{square(1), line({0, 0, 0}, {0, 0, 4})};
  sweep.rotation = {1, false, {{0, 0, 0}, {90, 0, 0}}};
  CHECK(volume_of(sweep, 0.002) == doctest::Approx(16).epsilon(0.002));
}

TEST_CASE("a sweep with full turns or several scale changes has its volume within 2 percent") {
  Sweep sweep{square(1), line({0, 0, 0}, {0, 0, 40})};
  sweep.rotation = {1, false, {{0, 0, 0}, {720, 0, 0}}};
  CHECK(swept::make_swept_solid(sweep, {0.1}).mesh.points.size() > 100);
  CHECK(volume_of(sweep, 0.02) == doctest::Approx(160).epsilon(0.02));
  sweep.rotation = {0, false, {{0, 0, 0}}};
  sweep.scale = {1, false, {{1, 1, 0}, {2, 2, 0}, {1, 1, 0}, {2, 2, 0}, {1, 1, 0}}};
  CHECK(volume_of(sweep, 0.02) == doctest::Approx(160 * 7.0 / 3).epsilon(0.01));
}

TEST_CASE("points of an evenly rotated and scaled sweep map back to the contour") {
  Sweep sweep{circle(1, 12), line({0, 0, 0}, {0, 0, 9})};
  for (glm::dvec3& point : sweep.contour.points) point.x *= 3;
  sweep.rotation = {1, false, {{0, 0, 0}, {120, 0, 0}}};
  sweep.scale = {1, false, {{1, 1, 0}, {3, 2, 0}}};
  constexpr double tolerance = 0.01;
  const swept::SweptSolid solid = swept::make_swept_solid(sweep, {tolerance});
  double most_off = 0;
  for (const glm::dvec3& point : solid.mesh.points) {
    const double part = point.z / 9;
    const double angle = -part * 2 * pi / 3;
    const double u = (point.x * std::cos(angle) - point.y * std::sin(angle)) / (1 + 2 * part);
    const double v = (point.x * std::sin(angle) + point.y * std::cos(angle)) / (1 + part);
    most_off = std::max(most_off, std::abs(std::hypot(u / 3, v) - 1));
  }
  CHECK(most_off < 2 * tolerance);
  // The contour is an ellipse of 3 and 1: its area times the integral of the scales.
  CHECK(volume(solid.mesh) == doctest::Approx(pi * 3 * 9 * (1 + 1.5 + 2.0 / 3)).epsilon(0.005));
}

TEST_CASE("rotation and scale follow the trajectory's length and not its parameter") {
  Sweep sweep{square(1), {1, false, {{0, 0, 0}, {0, 0, 1}, {0, 0, 10}}}};
  sweep.scale = {1, false, {{1, 1, 0}, {2, 2, 0}}};
  const swept::SweptSolid solid = swept::make_swept_solid(sweep, {0.01});
  for (const glm::dvec3& point : solid.mesh.points)
    CHECK(std::max(std::abs(point.x), std::abs(point.y)) == doctest::Approx(1 + point.z / 10));
}

TEST_CASE("a closed trajectory is mitred at corners: outer block minus inner block") {
  const Sweep sweep{square(1), {1, true, {{10, 0, 0}, {0, 0, 0}, {0, 0, 8}, {10, 0, 8}}}};
  CHECK(volume_of(sweep, 0.1) == doctest::Approx(2 * (12 * 10 - 8 * 6)));
}

TEST_CASE("a straight part along the y axis is rotated evenly without crossing itself") {
  const Sweep sweep{square(1), {1, true, {{14, 14, 0}, {-14, 14, 0}, {-14, -14, 0}, {14, -14, 0}}}};
  const swept::SweptSolid solid = swept::make_swept_solid(sweep, {0.02});
  CHECK(validation_error(solid) == "");
  CHECK(!solids::check(solid.mesh, 1e-9).crossing);
  CHECK(volume(solid.mesh) == doctest::Approx(4 * 4 * 28).epsilon(0.02));
}

TEST_CASE("a circle along a circle is a torus in volume and distance within tolerance") {
  const Sweep sweep{circle(2, 16), circle(7, 24, true)};
  for (const double tolerance : {0.2, 0.05, 0.01}) {
    const swept::SweptSolid solid = swept::make_swept_solid(sweep, {tolerance});
    CHECK(validation_error(solid) == "");
    const double surface = 4 * pi * pi * 2 * 7;
    CHECK(std::abs(volume(solid.mesh) - 2 * pi * pi * 4 * 7) < surface * tolerance);
    double most_off = 0;
    for (const auto& face : solid.mesh.faces) {
      glm::dvec3 middle(0);
      for (const std::uint32_t vertex : face) middle += solid.mesh.points[vertex] / static_cast<double>(face.size());
      for (const std::uint32_t vertex : face) {
        for (const double part : {0.0, 0.5, 1.0}) {
          const glm::dvec3 point = solid.mesh.points[vertex] * part + middle * (1 - part);
          const double ring = std::hypot(point.x, point.z) - 7;
          most_off = std::max(most_off, std::abs(std::hypot(ring, point.y) - 2));
        }
      }
    }
    CHECK(most_off < 2 * tolerance);
  }
}

TEST_CASE("the thesis's test leaves a ring's flat side undivided unlike the side test") {
  const Sweep ring{square(1), circle(8, 8, true)};
  // Depth of vertices inside the hole, whose radius is 7.
  const auto inside = [&](swept::Flatness flatness) {
    double most = 0;
    for (const glm::dvec3& point : swept::make_swept_solid(ring, {0.01, flatness}).mesh.points)
      most = std::max(most, 7 - std::hypot(point.x, point.z));
    return most;
  };
  CHECK(inside(swept::Flatness::plane) > 0.4);
  CHECK(inside(swept::Flatness::sides) < 0.02);
}

TEST_CASE("a trajectory through the y axis direction yields a closed oriented mesh") {
  const Sweep sweep{{3, true, {{1, 0, 0}, {0, 0.4, 0}, {-1, 0, 0}, {0, -0.4, 0}}},
                    {3, false, {{-8, 0, 0}, {-8, 6, 0}, {0, 12, 0}, {8, 6, 1}, {8, 0, 0}}}};
  CHECK(validation_error(swept::make_swept_solid(sweep, {0.05})) == "");
}

TEST_CASE("an upright ring that runs along the y axis at two places keeps its volume") {
  Sweep sweep{circle(1, 12), circle(9, 16)};
  for (glm::dvec3& point : sweep.contour.points) point.x *= 0.5;
  const swept::SweptSolid solid = swept::make_swept_solid(sweep, {0.02});
  CHECK(validation_error(solid) == "");
  CHECK(!solids::check(solid.mesh, 1e-9).crossing);
  CHECK(volume(solid.mesh) == doctest::Approx(2 * pi * 9 * pi * 0.5).epsilon(0.02));
}

TEST_CASE("random sweeps are closed with equal face counts and volumes by either repair") {
  CHECK(rc::check([] {
    Sweep sweep;
    sweep.contour = circle(1 + 0.01 * *rc::gen::inRange(0, 100), *rc::gen::inRange<std::size_t>(4, 9));
    sweep.contour.degree = *rc::gen::inRange<std::uint32_t>(1, 4);
    sweep.trajectory.degree = *rc::gen::inRange<std::uint32_t>(1, 4);
    sweep.trajectory.closed = *rc::gen::arbitrary<bool>();
    const auto count = *rc::gen::inRange<std::size_t>(4, 8);
    for (std::size_t i = 0; i < count; ++i) {
      const double angle =
          (sweep.trajectory.closed ? 2 * pi : pi) * static_cast<double>(i) / static_cast<double>(count);
      sweep.trajectory.points.emplace_back(20 * std::cos(angle), 0.05 * *rc::gen::inRange(-100, 101),
                                           20 * std::sin(angle) + 0.01 * *rc::gen::inRange(-100, 101));
    }
    if (!sweep.trajectory.closed) {
      const double end = 0.01 * *rc::gen::inRange(0, 100);
      sweep.scale = {2, false, {{1, 1, 0}, {0.5, 1, 0}, {end, end, 0}}};
      sweep.rotation = {1, false, {{0, 0, 0}, {static_cast<double>(*rc::gen::inRange(-200, 200)), 0, 0}}};
    }
    RC_ASSERT(swept::validation_error(sweep).empty());
    const swept::SweptSolid solid = swept::make_swept_solid(sweep, {0.1});
    RC_ASSERT(open_edge(solid.mesh.faces).empty());
    RC_ASSERT(volume(solid.mesh) > 0);
    const swept::SweptSolid other = swept::make_swept_solid(sweep, {0.1}, swept::Repair::quadtree);
    RC_ASSERT(other.mesh.faces.size() == solid.mesh.faces.size());
    RC_ASSERT(std::abs(volume(other.mesh) - volume(solid.mesh)) < 1e-9 * volume(solid.mesh));
    RC_ASSERT(open_edge(other.mesh.faces).empty());
  }));
}

TEST_CASE("an invalid sweep is reported with a fix") {
  const Sweep good{square(1), line({0, 0, 0}, {0, 0, 4})};
  CHECK(swept::validation_error(good) == "");
  Sweep open = good;
  open.contour.closed = false;
  CHECK(swept::validation_error(open) == "the contour is open; write `closed` in its curve");
  Sweep below = good;
  below.scale = {1, false, {{1, 1, 0}, {-1, 1, 0}}};
  CHECK(swept::validation_error(below) == "a scale is below 0, which would turn the solid inside out; use 0 or more");
  Sweep none = good;
  none.contour.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  CHECK(swept::validation_error(none) == "the contour encloses no area; move its points apart");
  Sweep many = good;
  many.contour.points.resize(400, {1, 2, 0});
  many.trajectory.points.resize(300, {0, 0, 9});
  CHECK(swept::validation_error(many) == "contour and trajectory make more than 100000 patches; remove points");
  Sweep back = good;
  back.trajectory.points = {{0, 0, 0}, {0, 0, 4}, {0, 0, 1}};
  CHECK(testing::error_of([&] { swept::make_swept_solid(back, {0.1}); }) ==
        "the trajectory reverses at the end of its segment 1; move that point");
  Sweep turned{square(1), circle(9, 8, true)};
  turned.rotation = {1, false, {{0, 0, 0}, {90, 0, 0}}};
  CHECK(testing::error_of([&] { swept::make_swept_solid(turned, {0.1}); }) ==
        "the contour does not match itself where the trajectory closes; change the rotation to a multiple of "
        "360 degrees in total, and end the scale at its initial value");
}
