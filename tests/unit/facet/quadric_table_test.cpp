#include <rapidcheck.h>

#include <glm/mat3x3.hpp>

#include "host/facet/geometry.h"
#include "host/facet/planes.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

using facet::QuadricKind;

facet::Faceting exact() {
  facet::Faceting faceting;
  faceting.exact_curves = true;
  return faceting;
}

model::Tree tree_of(std::vector<model::Primitive> primitives) {
  model::Tree tree;
  model::Node root{false, model::Operator::unite, model::no_index, {}};
  for (model::Primitive& one : primitives) {
    root.children.push_back(static_cast<std::uint32_t>(tree.nodes.size()));
    tree.nodes.push_back({true, model::Operator::unite, static_cast<std::uint32_t>(tree.primitives.size()), {}});
    tree.primitives.push_back(std::move(one));
  }
  tree.root = 0;
  if (root.children.size() > 1) {
    tree.root = static_cast<std::uint32_t>(tree.nodes.size());
    tree.nodes.push_back(std::move(root));
  }
  return tree;
}

facet::Geometry scene_of(std::vector<model::Primitive> primitives) {
  return facet::make_geometry(tree_of(std::move(primitives)), exact());
}

model::Primitive at(model::Shape shape, const glm::dmat4& place = glm::dmat4(1.0)) {
  return {std::move(shape), place, std::nullopt, {}};
}

glm::dmat4 moved(const glm::dvec3& by) {
  glm::dmat4 place(1.0);
  place[3] = glm::dvec4(by, 1.0);
  return place;
}

glm::dmat4 scaled(const glm::dvec3& by) {
  return {glm::dvec4(by.x, 0, 0, 0), glm::dvec4(0, by.y, 0, 0), glm::dvec4(0, 0, by.z, 0), glm::dvec4(0, 0, 0, 1)};
}

glm::dmat4 rotated(int axis, double degrees) {
  const double angle = degrees * std::numbers::pi / 180.0;
  glm::dmat4 turn(1.0);
  const int i = (axis + 1) % 3;
  const int j = (axis + 2) % 3;
  turn[i][i] = turn[j][j] = std::cos(angle);
  turn[i][j] = std::sin(angle);
  turn[j][i] = -std::sin(angle);
  return turn;
}

double real(int low, int high) { return *rc::gen::inRange(low * 1000, high * 1000) / 1000.0; }
glm::dvec3 vector(int low, int high) { return {real(low, high), real(low, high), real(low, high)}; }
glm::dmat4 random_rotation() {
  return rotated(0, real(-180, 180)) * rotated(1, real(-180, 180)) * rotated(2, real(-180, 180));
}
/// Random scale from 10^-3 to 10^3.
double factor() { return std::pow(10.0, real(-3, 3)); }
glm::dmat4 random_transform() {
  return moved(vector(-50, 50)) * random_rotation() * scaled({factor(), factor(), factor()}) * random_rotation();
}

model::Cylinder cylinder(double height, double r1, double r2, bool center = false) {
  return {height, r1, r2, center, {}};
}

/// Value at a point relative to the table's centre.
double value(const facet::Quadric& quadric, const glm::dvec3& point) {
  double sum = quadric.level();
  for (std::size_t i = 0; i < 3; ++i) {
    const double u = glm::dot(quadric.to_unit[i], point - quadric.origin);
    sum += quadric.signs()[i] * u * u;
  }
  return sum;
}

/// Whether both primitives share a quadric with the same side.
bool coincide(const model::Primitive& first, const model::Primitive& second) {
  const facet::Geometry scene = scene_of({first, second});
  return scene.quadrics.quadrics().size() == 1 && scene.solids[0].quadrics == scene.solids[1].quadrics;
}

glm::dvec3 place(const glm::dmat4& transform, const glm::dvec3& point) {
  return glm::dvec3(transform * glm::dvec4(point, 1.0));
}

}  // namespace

TEST_CASE("a sphere that stays curved is one quadric under any transform") {
  CHECK(rc::check([] {
    const glm::dmat4 matrix = random_transform();
    const double radius = real(1, 9);
    const facet::Geometry scene = scene_of({at(model::Sphere{radius, {}}, matrix)});
    RC_ASSERT(scene.solids[0].halfspaces.empty());
    RC_ASSERT(scene.solids[0].quadrics.size() == 1U);
    const facet::Quadric& quadric = scene.quadrics.quadrics()[0];
    RC_ASSERT(quadric.kind == QuadricKind::ellipsoid);
    const glm::dvec3 direction = glm::normalize(vector(-9, 9) + glm::dvec3(0.0005));
    const glm::dvec3 on = place(matrix, direction * radius) - scene.quadrics.centre();
    // A point in model space keeps six digits across 6 decades of scale.
    RC_ASSERT(std::abs(value(quadric, on)) < 1e-6);
    RC_ASSERT(value(quadric, place(matrix, direction * radius * 0.99) - scene.quadrics.centre()) < 0.0);
    const facet::Box& box = scene.solids[0].box;
    const glm::dvec3 slack = 1e-9 * (glm::abs(box.low) + glm::abs(box.high));
    for (int axis = 0; axis < 3; ++axis) {
      RC_ASSERT(place(matrix, direction * radius)[axis] <= box.high[axis] + slack[axis]);
      RC_ASSERT(place(matrix, direction * radius)[axis] >= box.low[axis] - slack[axis]);
    }
  }));
}

TEST_CASE("a cylinder is two planes and a quadric with a nappe selected by the axis") {
  CHECK(rc::check([] {
    const glm::dmat4 matrix = random_transform();
    const double r1 = real(0, 5);
    const double r2 = *rc::gen::arbitrary<bool>() ? r1 : real(0, 5);
    RC_PRE(r1 > 0.0 || r2 > 0.0);
    const model::Cylinder shape = cylinder(real(1, 9), r1, r2, *rc::gen::arbitrary<bool>());
    const facet::Geometry scene = scene_of({at(shape, matrix)});
    const facet::Convex& solid = scene.solids[0];
    RC_ASSERT(solid.halfspaces.size() == 2U);
    RC_ASSERT(solid.quadrics.size() == 1U);
    const facet::Quadric& quadric = scene.quadrics.quadrics()[0];
    RC_ASSERT(quadric.kind == (r1 == r2 ? QuadricKind::cylinder : QuadricKind::cone));
    const double part = real(0, 1);
    const double angle = real(-4, 4);
    const double radius = r1 + (r2 - r1) * part;
    const double z = shape.height * (part - (shape.center ? 0.5 : 0.0));
    const auto on = [&](double scale) {
      return place(matrix, {radius * scale * std::cos(angle), radius * scale * std::sin(angle), z}) -
             scene.quadrics.centre();
    };
    const double scale = glm::length(quadric.to_unit[0]) + glm::length(quadric.to_unit[1]);
    const double noise = 1e-12 * (1.0 + scale * scale * std::pow(glm::length(on(1.0) - quadric.origin) + 1.0, 2.0));
    RC_ASSERT(std::abs(value(quadric, on(1.0))) <= noise);
    RC_ASSERT(value(quadric, on(0.9)) <= noise);
    if (quadric.kind == QuadricKind::cone && radius > 0.01 * (r1 + r2)) {
      const double along = glm::dot(on(0.5) - quadric.origin, quadric.axis);
      RC_ASSERT((along > 0.0) == solid.quadrics[0].along_axis);
    }
  }));
}

TEST_CASE("the hulls of curved solids contain them in every direction") {
  CHECK(rc::check([] {
    const glm::dmat4 matrix = random_transform();
    const model::Cylinder shape = cylinder(real(1, 9), real(0, 5), real(1, 5), *rc::gen::arbitrary<bool>());
    const bool is_ball = *rc::gen::arbitrary<bool>();
    const double radius = real(1, 9);
    const facet::Geometry scene = scene_of({is_ball ? at(model::Sphere{radius, {}}, matrix) : at(shape, matrix)});
    const glm::dvec3 direction = glm::normalize(vector(-9, 9) + glm::dvec3(0.0005));
    const glm::dmat3 linear(matrix);
    const glm::dvec3 back = glm::transpose(linear) * direction;
    const double low = shape.center ? -shape.height / 2.0 : 0.0;
    const double across = std::hypot(back.x, back.y);
    const double support =
        glm::dot(direction, glm::dvec3(matrix[3])) +
        (is_ball ? radius * glm::length(back)
                 : std::max(low * back.z + shape.r1 * across, (low + shape.height) * back.z + shape.r2 * across));
    double most = -INFINITY;
    for (const glm::dvec3& vertex : scene.solids[0].vertices) most = std::max(most, glm::dot(direction, vertex));
    RC_ASSERT(most >= support - 1e-9 * (std::abs(support) + std::abs(most)));
    RC_ASSERT(scene.solids[0].edges.size() >= scene.solids[0].vertices.size());
  }));
}

TEST_CASE("equal surfaces share a quadric regardless of their transforms") {
  CHECK(rc::check([] {
    const double radius = real(1, 9);
    const glm::dmat4 matrix = moved(vector(-50, 50)) * random_rotation() * scaled(glm::dvec3(factor()));
    const model::Sphere ball{radius, {}};
    RC_ASSERT(coincide(at(ball, matrix), at(ball, matrix * random_rotation())));
    RC_ASSERT(coincide(at(ball, matrix), at(model::Sphere{2.0 * radius, {}}, matrix * scaled({-0.5, 0.5, 0.5}))));
    const double height = real(1, 9);
    const model::Cylinder tube = cylinder(height, radius, radius);
    RC_ASSERT(
        coincide(at(tube, matrix), at(cylinder(real(1, 9), radius, radius), matrix * moved({0, 0, real(-9, 9)}))));
    RC_ASSERT(coincide(at(tube, matrix), at(cylinder(height, radius, radius, true), matrix * rotated(0, 180))));
    RC_ASSERT(coincide(at(tube, matrix), at(tube, matrix * scaled({1, 1, -1}) * rotated(2, real(-180, 180)))));
    // Parts of one cone, seen from below and above.
    const double taper = real(1, 9) / 10.0;
    const model::Cylinder whole = cylinder(radius / taper, radius, 0);
    const model::Cylinder part = cylinder(0.5 * radius / taper, radius, 0.5 * radius);
    const model::Cylinder over = cylinder(0.5 * radius / taper, 0.5 * radius, radius);
    RC_ASSERT(coincide(at(whole, matrix), at(part, matrix)));
    RC_ASSERT(coincide(at(whole, matrix),
                       at(over, matrix * moved({0, 0, 0.5 * radius / taper}) * scaled({1, 1, -1}) * rotated(2, 33))));
    const facet::Geometry nappes =
        scene_of({at(whole, matrix), at(whole, matrix * moved({0, 0, 2.0 * radius / taper}) * scaled({1, 1, -1}))});
    RC_ASSERT(nappes.quadrics.quadrics().size() == 1U);
    RC_ASSERT(nappes.solids[0].quadrics[0].along_axis != nappes.solids[1].quadrics[0].along_axis);
  }));
}

TEST_CASE("surfaces that differ by 10^-10 of the model stay separate quadrics") {
  const double more = 1.0 + 1e-10;
  for (const glm::dmat4& matrix : {glm::dmat4(1.0), rotated(0, 33) * rotated(1, 21)}) {
    CHECK_FALSE(coincide(at(model::Sphere{5, {}}, matrix), at(model::Sphere{5 * more, {}}, matrix)));
    CHECK_FALSE(coincide(at(cylinder(4, 5, 5), matrix), at(cylinder(4, 5 * more, 5 * more), matrix)));
    CHECK_FALSE(coincide(at(cylinder(4, 5, 2), matrix), at(cylinder(4, 5, 2 - 1e-9), matrix)));
    CHECK_FALSE(coincide(at(cylinder(4, 5, 5), matrix), at(cylinder(4, 5, 5), matrix * moved({1e-9, 0, 0}))));
    CHECK_FALSE(coincide(at(cylinder(1e-3, 5, 0), matrix), at(cylinder(1e-3 + 1e-9, 5, 0), matrix)));
    CHECK_FALSE(coincide(at(cylinder(4, 5, 5), matrix), at(model::Sphere{5, {}}, matrix)));
  }
}

TEST_CASE("equal ellipsoids coincide for semi-axes across six decades") {
  CHECK(rc::check([] {
    const glm::dmat4 turn = moved(vector(-9, 9)) * random_rotation();
    const glm::dvec3 sizes(factor(), factor(), factor());
    const model::Sphere unit{1, {}};
    const glm::dmat4 first = turn * scaled(sizes);
    RC_ASSERT(coincide(at(unit, first), at(unit, first * random_rotation())));
    const facet::Geometry scene = scene_of({at(unit, first)});
    const facet::Quadric& quadric = scene.quadrics.quadrics()[0];
    for (int axis = 0; axis < 3; ++axis) {
      // The ends of the axes lie on the quadric, as exactly as points of this size can be represented.
      glm::dvec3 end(0);
      end[axis] = 1;
      const double most =
          std::max({glm::length(quadric.to_unit[0]), glm::length(quadric.to_unit[1]), glm::length(quadric.to_unit[2])});
      RC_ASSERT(std::abs(value(quadric, place(first, end) - scene.quadrics.centre())) < 1e-13 * (1.0 + most * 1e3));
    }
  }));
}

TEST_CASE("polygonal solids are faceted and without exact curves every solid is") {
  const auto quadrics_with = [](double fn, const facet::Faceting& faceting) {
    const model::Tree tree = tree_of({at(model::Cylinder{4, 5, 5, false, {fn, 12, 2}})});
    return facet::make_geometry(tree, faceting).solids[0].quadrics.size();
  };
  CHECK(quadrics_with(0, exact()) == 1);
  CHECK(quadrics_with(6, exact()) == 0);
  CHECK(quadrics_with(12, exact()) == 0);
  CHECK(quadrics_with(13, exact()) == 1);
  CHECK(quadrics_with(0, {}) == 0);
  facet::Faceting all = exact();
  all.min_round_sides = 0;
  CHECK(quadrics_with(6, all) == 1);
  const model::Tree both = tree_of({at(model::Sphere{2, {}}), at(model::Sphere{3, {}})});
  facet::Faceting second = exact();
  second.faceted = {true, false};
  const facet::Geometry scene = facet::make_geometry(both, second);
  CHECK(scene.solids[0].quadrics.empty());
  CHECK(scene.solids[1].quadrics.size() == 1);
}

TEST_CASE("a cone too slender for an apex becomes a cylinder of its mean radius") {
  const facet::Geometry scene = scene_of({at(cylinder(4, 5, 5 + 1e-8))});
  CHECK(scene.quadrics.quadrics()[0].kind == QuadricKind::cylinder);
  CHECK(scene.solids[0].halfspaces.size() == 2);
  CHECK(scene_of({at(cylinder(4, 5, 5 + 1e-6))}).quadrics.quadrics()[0].kind == QuadricKind::cone);
}

TEST_CASE("a hundred thousand quadrics are distinguished in near-linear time") {
  facet::QuadricTable table(glm::dvec3(0), 1000.0);
  const auto add = [&](int i) {
    facet::Quadric one;
    one.origin = glm::dvec3(i % 100, i / 100 % 100, i / 10'000);
    one.to_unit = {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)};
    return table.add(one, glm::dvec3(0)).quadric;
  };
  for (int i = 0; i < 100'000; ++i) REQUIRE(add(i) == static_cast<std::uint32_t>(i));
  for (int i = 0; i < 100'000; i += 997) CHECK(add(i) == static_cast<std::uint32_t>(i));
}
