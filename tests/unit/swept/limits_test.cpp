#include "host/swept/mesh.h"
#include "host/swept/net.h"
#include "host/swept/spine.h"
#include "host/swept/surface.h"
#include "tests/support/test.h"
#include "tests/unit/swept/support.h"

using namespace csgsim;
using namespace swept;

namespace {

Curve square(double half) {
  return {1, true, {{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}}};
}

/// A closed cubic close to a circle.
Curve circle(double radius, std::size_t points, bool in_xz = false) {
  Curve curve{3, true, {}};
  const double out = radius * 3 / (2 + std::cos(2 * std::numbers::pi / static_cast<double>(points)));
  for (std::size_t i = 0; i < points; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(points);
    const double x = out * std::cos(angle);
    const double y = out * std::sin(angle);
    curve.points.push_back(in_xz ? glm::dvec3{x, 0, y} : glm::dvec3{x, y, 0});
  }
  return curve;
}

Curve line(double length) { return {1, false, {{0, 0, 0}, {0, 0, length}}}; }

/// A function with one value, such as a rotation.
Curve function(std::uint32_t degree, const std::vector<double>& values) {
  Curve curve{degree, false, {}};
  for (const double value : values) curve.points.emplace_back(value, 0, 0);
  return curve;
}

Sweep block() { return {square(1), line(10)}; }

std::string sweep_error(const Sweep& sweep) {
  return testing::error_of([&] { swept::make_swept_solid(sweep, {0.1}); });
}

std::size_t leaves_of(const Sweep& sweep, std::size_t column, const swept::Accuracy& accuracy) {
  return swept_test::leaves_of(*swept::make_surface(sweep), column, 0, accuracy).size();
}

Net make_net(std::size_t rows, std::size_t columns) {
  Net net;
  for (std::size_t row = 0; row < rows; ++row) {
    std::vector<glm::dvec3>& points = net.rows.emplace_back();
    for (std::size_t column = 0; column < columns; ++column)
      points.emplace_back(static_cast<double>(column), static_cast<double>(row), 0);
  }
  return net;
}

}  // namespace

TEST_CASE("the error for a wrong curve of a sweep names the curve") {
  const Curve bad{4, false, {}};
  const std::string what = ": degree 4 is above 3; use 0 (constant), 1, 2 or 3";
  Sweep sweep = block();
  sweep.contour = bad;
  CHECK(swept::validation_error(sweep) == "the contour" + what);
  sweep = block();
  sweep.trajectory = bad;
  CHECK(swept::validation_error(sweep) == "the trajectory" + what);
  sweep = block();
  sweep.rotation = bad;
  CHECK(swept::validation_error(sweep) == "the rotation" + what);
  sweep = block();
  sweep.scale = bad;
  CHECK(swept::validation_error(sweep) == "the scale" + what);
}

TEST_CASE("a point as contour or trajectory and a closed rotation or scale are rejected") {
  Sweep sweep = block();
  sweep.contour = {0, true, {{1, 1, 0}}};
  CHECK(swept::validation_error(sweep).find("the contour") == 0);
  sweep = block();
  sweep.trajectory = {0, false, {{1, 1, 0}}};
  CHECK(swept::validation_error(sweep) == "the trajectory is a point; use degree 1, 2 or 3");
  for (const bool is_rotation : {true, false}) {
    sweep = block();
    (is_rotation ? sweep.rotation : sweep.scale) = {1, true, {{1, 1, 0}, {2, 2, 0}, {3, 3, 0}}};
    CHECK(swept::validation_error(sweep) == "rotation and scale cannot be closed; use `open`");
  }
}

TEST_CASE("a negative scale along u or v is rejected at any point and 0 accepted") {
  for (const glm::dvec3& point : {glm::dvec3{-0.1, 1, 0}, glm::dvec3{1, -0.1, 0}}) {
    for (const bool is_last : {false, true}) {
      Sweep sweep = block();
      sweep.scale = {1, false, {{1, 1, 0}, {1, 1, 0}}};
      (is_last ? sweep.scale.points.back() : sweep.scale.points.front()) = point;
      CHECK(swept::validation_error(sweep) ==
            "a scale is below 0, which would turn the solid inside out; use 0 or more");
    }
  }
  Sweep sweep = block();
  sweep.scale = {1, false, {{0, 1, 0}, {1, 0, 0}}};
  CHECK(swept::validation_error(sweep).empty());
}

TEST_CASE("a sweep with the most points and patches is accepted and with one more rejected") {
  CHECK(swept::validation_error(Curve{1, false, std::vector<glm::dvec3>(10'000)}).empty());
  CHECK(!swept::validation_error(Curve{1, false, std::vector<glm::dvec3>(10'001)}).empty());
  for (std::uint32_t degree = 1; degree <= 3; ++degree) {
    CAPTURE(degree);
    CHECK(swept::validation_error(Curve{degree, false, std::vector<glm::dvec3>(degree + 1)}).empty());
    CHECK(!swept::validation_error(Curve{degree, false, std::vector<glm::dvec3>(degree)}).empty());
    const std::size_t fewest = degree == 3 ? 4 : 3;
    CHECK(swept::validation_error(Curve{degree, true, std::vector<glm::dvec3>(fewest)}).empty());
    CHECK(!swept::validation_error(Curve{degree, true, std::vector<glm::dvec3>(fewest - 1)}).empty());
  }
  Sweep sweep = block();
  sweep.contour.points.resize(1000, {1, 2, 0});
  sweep.trajectory.points.resize(100, {0, 0, 9});
  CHECK(swept::validation_error(sweep).empty());
  sweep.trajectory.points.resize(101, {0, 0, 9});
  CHECK(swept::validation_error(sweep) == "contour and trajectory make more than 100000 patches; remove points");
}

TEST_CASE("a net has at least four equal rows of four points and at most 100000 patches") {
  CHECK(swept::validation_error(make_net(4, 4)).empty());
  CHECK(swept::validation_error(make_net(3, 4)) == "a patch needs at least 4 rows of points, not 3");
  CHECK(swept::validation_error(make_net(4, 3)) == "a row of a patch needs at least 4 points, not 3");
  Net uneven = make_net(4, 5);
  uneven.rows[3].pop_back();
  CHECK(swept::validation_error(uneven) == "rows of a patch have 5 and 4 points; make them equally long");
  CHECK(swept::validation_error(make_net(103, 1003)).empty());
  CHECK(swept::validation_error(make_net(104, 1003)) == "more than 100000 patches; remove points");
  CHECK(swept::validation_error(make_net(103, 1004)) == "more than 100000 patches; remove points");
}

TEST_CASE("on a closed trajectory the scale along u and v and the rotation must close") {
  const std::string open =
      "the contour does not match itself where the trajectory closes; change the rotation to a multiple of "
      "360 degrees in total, and end the scale at its initial value";
  Sweep ring{square(1), circle(9, 8, true)};
  ring.rotation = function(1, {0, 360});
  CHECK(sweep_error(ring) == "");
  ring.rotation = function(1, {0, 180});
  CHECK(sweep_error(ring) == open);
  ring.rotation = function(0, {0});
  for (const glm::dvec3& end : {glm::dvec3{1.5, 1, 0}, glm::dvec3{1, 1.5, 0}}) {
    ring.scale = {1, false, {{1, 1, 0}, end}};
    CHECK(sweep_error(ring) == open);
  }
}

TEST_CASE("a trajectory that stands still at its start or middle or end is rejected") {
  for (const std::size_t segment : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
    std::vector<glm::dvec3> points{{0, 0, 0}, {0, 0, 3}, {0, 0, 6}};
    points.insert(points.begin() + static_cast<std::ptrdiff_t>(segment), points[segment]);
    CHECK(sweep_error({square(1), {1, false, points}}) ==
          "all points of segment " + std::to_string(segment + 1) + " of the trajectory coincide; remove points");
  }
}

TEST_CASE("a segment is short if its rotation back and forth totals at most 90 degrees") {
  const auto is_short = [](const Curve& rotation) {
    Sweep sweep = block();
    sweep.rotation = rotation;
    return swept::Spine(sweep).is_short(0, 0, 1);
  };
  CHECK(is_short(function(1, {0, 90})));
  CHECK(is_short(function(1, {90, 0})));
  CHECK(!is_short(function(1, {0, 90.5})));
  CHECK(!is_short(function(1, {90.5, 0})));
  // A parabola that rotates to 50 degrees and back totals 100, one to 40 and back 80.
  CHECK(!is_short(function(2, {0, 100, 0})));
  CHECK(!is_short(function(2, {0, -100, 0})));
  CHECK(is_short(function(2, {0, 80, 0})));
  CHECK(is_short(function(2, {0, -80, 0})));
}

TEST_CASE("a twist to one side and back within a segment of a sweep is drawn") {
  // The rotation is 0 at both ends and in the middle.
  Sweep sweep = block();
  sweep.rotation = function(3, {0, 300, -300, 0});
  const swept::SweptSolid solid = swept::make_swept_solid(sweep, {0.05});
  CHECK(solid.mesh.points.size() > 100);
  double most = 0;
  for (const glm::dvec3& point : solid.mesh.points) {
    const double t = point.z / 10;
    const double angle = (900 * t * (1 - t) * (1 - t) - 900 * t * t * (1 - t)) * std::numbers::pi / 180;
    const double u = point.x * std::cos(angle) + point.y * std::sin(angle);
    const double v = point.y * std::cos(angle) - point.x * std::sin(angle);
    most = std::max(most, std::abs(std::max(std::abs(u), std::abs(v)) - 1));
  }
  CHECK(most < 0.1);
}

TEST_CASE("rims of cones are within tolerance in both directions of the trajectory") {
  // With corners 22.5 degrees apart, a side of the rim is 0.058 off the circle, and the middle of a patch's upper half
  // three quarters of that: only the rim exceeds the tolerance.
  constexpr double tolerance = 0.05;
  for (const bool opens : {true, false}) {
    CAPTURE(opens);
    Sweep sweep{circle(3, 8), line(10)};
    const glm::dvec3 tip(0, 0, 0);
    const glm::dvec3 rim(1, 1, 0);
    sweep.scale = {1, false, {opens ? tip : rim, opens ? rim : tip}};
    const swept::SweptSolid solid = swept::make_swept_solid(sweep, {tolerance});
    const double height = opens ? 10 : 0;
    std::vector<double> angles;
    for (const glm::dvec3& point : solid.mesh.points) {
      if (point.z == height) angles.push_back(std::atan2(point.y, point.x));
    }
    std::ranges::sort(angles);
    REQUIRE(angles.size() > 8);
    for (std::size_t i = 1; i < angles.size(); ++i)
      CHECK(3 * (1 - std::cos((angles[i] - angles[i - 1]) / 2)) < tolerance);
  }
}

TEST_CASE("a patch with one bent side is subdivided whichever side it is") {
  // The patch has the trajectory on one side and, on the other, a point that the scale moves along a parabola, 4 off a
  // line; an eighth of that side is 1/16 off.
  Sweep sweep{{1, true, {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}}}, line(10)};
  sweep.scale = {2, false, {{1, 1, 0}, {3, 3, 0}, {1, 1, 0}}};
  CHECK(leaves_of(sweep, 0, {0.1}) >= 8);  // bent in the east
  CHECK(leaves_of(sweep, 2, {0.1}) >= 8);  // bent in the west
}

TEST_CASE("a surface at its limits on levels or elements or work is accepted but not beyond") {
  Sweep sweep{circle(3, 8), line(10)};
  sweep.scale = {2, false, {{1, 1, 0}, {3, 3, 0}, {1, 1, 0}}};
  const std::unique_ptr<swept::Surface> surface = swept::make_surface(sweep);
  const std::vector<swept::Element> leaves = swept_test::leaves_of(*surface, 0, 0, {0.01});
  const auto smallest = std::ranges::min_element(leaves, {}, [](const auto& leaf) { return leaf.square.size; });
  std::uint32_t levels = 0;
  while (swept::whole_side >> levels > smallest->square.size) ++levels;
  REQUIRE(levels > 2);
  const auto subdividing = [&](const swept::Accuracy& accuracy, std::uint64_t elements) {
    return testing::error_of([&] {
      // No results of an earlier subdivision are kept.
      const std::unique_ptr<swept::Surface> anew = swept::make_surface(sweep);
      swept::SubdivisionCounts counts;
      counts.elements = elements;
      const std::unique_ptr<swept::Stream> stream = anew->subdivide(0, 0, accuracy, counts);
      while (stream->next()) {
      }
    });
  };
  const swept::Flatness sides = swept::Flatness::sides;
  CHECK(subdividing({0.01, sides, levels}, 0) == "");
  CHECK(subdividing({0.01, sides, levels - 1}, 0).find("after " + std::to_string(levels - 1) + " halvings") !=
        std::string::npos);
  CHECK(subdividing({0.01}, swept::most_elements - leaves.size()) == "");
  CHECK(subdividing({0.01}, swept::most_elements - leaves.size() + 1) ==
        "a surface needs more than 2000000 elements; use a coarser tolerance");
  const Work counting(1'000'000'000);
  CHECK(subdividing({0.01, sides, 12, counting}, 0) == "");
  CHECK(subdividing({0.01, sides, 12, Work(counting.done())}, 0) == "");
  CHECK(subdividing({0.01, sides, 12, Work(counting.done() - 1)}, 0).find("subdividing a surface needs more work") ==
        0);
}