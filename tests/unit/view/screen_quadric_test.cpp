#include "host/view/screen_quadric.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "host/facet/geometry.h"
#include "host/view/projection.h"
#include "hw/isa/depth_scale.h"
#include "tests/support/rounds.h"
#include "tests/support/usual_cases.h"
#include "tests/unit/view/held.h"

using namespace csgsim;

namespace {

using Real = boost::multiprecision::cpp_bin_float_100;
using Vec = std::array<Real, 3>;

double real(int low, int high) { return *rc::gen::inRange(low * 1000, high * 1000) / 1000.0; }
glm::dvec3 vector(int low, int high) { return {real(low, high), real(low, high), real(low, high)}; }

glm::dmat4 turn_about(int axis, double angle) {
  glm::dmat4 turn(1.0);
  const int i = (axis + 1) % 3;
  const int j = (axis + 2) % 3;
  turn[i][i] = turn[j][j] = std::cos(angle);
  turn[i][j] = std::sin(angle);
  turn[j][i] = -std::sin(angle);
  return turn;
}

glm::dmat4 rotation() { return turn_about(0, real(-4, 4)) * turn_about(1, real(-4, 4)) * turn_about(2, real(-4, 4)); }

glm::dmat4 scaling(const glm::dvec3& by) {
  glm::dmat4 matrix(1.0);
  for (int i = 0; i < 3; ++i) matrix[i][i] = by[i];
  return matrix;
}

glm::dmat4 shift(const glm::dvec3& by) {
  glm::dmat4 matrix(1.0);
  matrix[3] = glm::dvec4(by, 1.0);
  return matrix;
}

model::Tree single(model::Shape shape, const glm::dmat4& place) {
  model::Tree tree;
  tree.primitives.push_back({std::move(shape), place, std::nullopt, {}});
  tree.nodes.push_back({true, model::Operator::unite, 0, {}});
  tree.root = 0;
  return tree;
}

facet::Faceting exact() {
  facet::Faceting faceting;
  faceting.exact_curves = true;
  return faceting;
}

struct Subject {
  model::Tree tree;
  view::Camera camera;
  view::Sampling sampling;
};

/// Shapes of many sizes and places, seen from outside and from inside, from far and near, with few and many bits.
Subject random_subject() {
  const double size = std::pow(10.0, real(-3, 3));
  const glm::dvec3 squeeze(std::pow(10.0, real(-1, 1)), std::pow(10.0, real(-1, 1)), 1.0);
  const glm::dvec3 far_off = *rc::gen::arbitrary<bool>() ? glm::dvec3(0) : vector(-5000, 5000) * size;
  const glm::dmat4 place = shift(far_off) * rotation() * scaling(size * squeeze);
  const bool is_uniform = *rc::gen::arbitrary<bool>();
  const glm::dmat4 used = is_uniform ? shift(far_off) * rotation() * scaling(glm::dvec3(size)) : place;
  Subject subject;
  const int kind = *rc::gen::inRange(0, 3);
  const double r1 = real(0, 4);
  const double r2 = kind == 1 ? r1 + 0.001 : *rc::gen::element(0.0, real(1, 4), 5.0 * r1 + 1.0);
  if (kind == 0) {
    subject.tree = single(model::Sphere{real(1, 4), {}}, used);
  } else {
    subject.tree = single(
        model::Cylinder{real(1, 9), kind == 1 ? r2 : r1, r1 + r2 > 0 ? r2 : 1.0, *rc::gen::arbitrary<bool>(), {}},
        used);
  }
  const double distance = *rc::gen::element(1.0, 3.0, 30.0, 1000.0);
  const glm::dvec3 back = glm::normalize(vector(-4, 4) + glm::dvec3(0.0005));
  const glm::dvec3 look = far_off + size * vector(-2, 2);
  subject.camera = {look + size * distance * back, look,
                    *rc::gen::arbitrary<bool>() ? view::Projection::perspective : view::Projection::orthographic};
  if (*rc::gen::arbitrary<bool>() && subject.camera.projection == view::Projection::orthographic)
    subject.camera.eye = look + size * 30.0 * back;
  subject.sampling.width = static_cast<std::uint32_t>(*rc::gen::inRange(8, 48));
  subject.sampling.height = static_cast<std::uint32_t>(*rc::gen::inRange(8, 48));
  subject.sampling.z_bits = static_cast<unsigned>(*rc::gen::inRange(6, 25));
  subject.sampling.fraction_bits = static_cast<unsigned>(*rc::gen::inRange(6, 16));
  subject.sampling.offset = {real(-1, 1) / 2.0, real(-1, 1) / 2.0};
  return subject;
}

/// A shape in its own space, met by the ray of a pixel at start + distance * direction: a t^2 + 2 b t + c <= 0.
struct Met {
  Real a = 0;
  Real b = 0;
  Real c = 0;
  Vec start;  // in the shape's space
  Vec direction;
};

Vec own_space(const glm::dmat4& m, const Vec& v) {
  const auto minor = [&](int i, int j, int k, int l) { return Real(m[i][j]) * m[k][l] - Real(m[k][j]) * m[i][l]; };
  const Real determinant =
      Real(m[0][0]) * minor(1, 1, 2, 2) - Real(m[1][0]) * minor(0, 1, 2, 2) + Real(m[2][0]) * minor(0, 1, 1, 2);
  // Cramer's rule.
  Vec out;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    const auto cross = [&](int row) {
      const int p = (row + 1) % 3;
      const int q = (row + 2) % 3;
      return Real(m[j][p]) * m[k][q] - Real(m[j][q]) * m[k][p];
    };
    out[static_cast<std::size_t>(i)] = (cross(0) * v[0] + cross(1) * v[1] + cross(2) * v[2]) / determinant;
  }
  return out;
}

Met meet(const Subject& subject, double x, double y) {
  const view::EyeSpace space = view::eye_space(subject.camera, subject.sampling);
  const model::Primitive& primitive = subject.tree.primitives[0];
  const Real right = (Real(x) - space.middle_x) * space.pixel;
  const Real up = (Real(space.middle_y) - y) * space.pixel;
  Vec start;
  Vec direction;
  for (int i = 0; i < 3; ++i) {
    const auto n = static_cast<std::size_t>(i);
    const Real across = right * space.axes.right[i] + up * space.axes.up[i];
    direction[n] = Real(space.axes.forward[i]) + (space.perspective ? across : Real(0));
    start[n] = Real(space.eye[i]) - primitive.transform[3][i] + (space.perspective ? Real(0) : across);
  }
  Met met;
  met.start = own_space(primitive.transform, start);
  met.direction = own_space(primitive.transform, direction);
  const auto add = [&](std::size_t axis, const Real& sign, const Real& from) {
    met.a += sign * met.direction[axis] * met.direction[axis];
    met.b += sign * met.direction[axis] * (met.start[axis] - from);
    met.c += sign * (met.start[axis] - from) * (met.start[axis] - from);
  };
  add(0, 1, 0);
  add(1, 1, 0);
  if (const auto* sphere = std::get_if<model::Sphere>(&primitive.shape)) {
    add(2, 1, 0);
    met.c -= Real(sphere->radius) * sphere->radius;
    return met;
  }
  const auto& cylinder = std::get<model::Cylinder>(primitive.shape);
  if (cylinder.r1 == cylinder.r2) {
    met.c -= Real(cylinder.r1) * cylinder.r1;
    return met;
  }
  const Real low = cylinder.center ? -cylinder.height / 2 : 0.0;
  const Real rise = Real(cylinder.r1) - cylinder.r2;
  add(2, -(rise / cylinder.height) * (rise / cylinder.height), low + cylinder.height * Real(cylinder.r1) / rise);
  return met;
}

/// Middle and discriminant in depth steps; nothing where the coefficient of the depth's square is 0.
struct Truth {
  Real middle;
  Real discriminant;
};

Truth truth_of(const view::View& view, const Met& met) {
  const Real near = view.depth.near;
  const Real far = view.depth.far;
  const Real steps = isa::depth_steps(view.sampling.z_bits);
  const Real root = met.b * met.b - met.a * met.c;
  if (view.depth.perspective) {
    const Real scale = steps / (1 / near - 1 / far);
    return {1 + (1 / near + met.b / met.c) * scale, root / (met.c * met.c) * scale * scale};
  }
  const Real scale = steps / (far - near);
  return {1 + (-met.b / met.a - near) * scale, root / (met.a * met.a) * scale * scale};
}

Real distance_at(const view::View& view, double depth) {
  const Real near = view.depth.near;
  const Real far = view.depth.far;
  const Real part = (Real(depth) - 1) / isa::depth_steps(view.sampling.z_bits);
  if (view.depth.perspective) return 1 / (1 / near - part * (1 / near - 1 / far));
  return near + part * (far - near);
}

/// Whether a place on a ray is in the shape, its planes included.
bool is_in(const Subject& subject, const Met& met, const Real& distance) {
  const model::Primitive& primitive = subject.tree.primitives[0];
  const auto at = [&](std::size_t axis) -> Real { return met.start[axis] + distance * met.direction[axis]; };
  if ((met.a * distance + 2 * met.b) * distance + met.c > 0) return false;
  const auto* cylinder = std::get_if<model::Cylinder>(&primitive.shape);
  if (cylinder == nullptr) return true;
  const double low = cylinder->center ? -cylinder->height / 2 : 0.0;
  return at(2) >= low && at(2) <= low + cylinder->height;
}

glm::dmat4 rotated_by_a_third() { return turn_about(0, 1.0 / 3) * turn_about(1, 1.0 / 3); }

bool representable(const view::View& view) {
  return std::all_of(view.planes.begin(), view.planes.end(),
                     [](const view::ScreenPlane& plane) { return plane.representable; });
}

}  // namespace

TEST_CASE("middle and discriminant are within their bounds of the truth") {
  int fit = 0;
  int inside = 0;
  const auto bounded = [&] {
    const Subject subject = random_subject();
    const facet::Geometry scene = facet::make_geometry(subject.tree, exact());
    const view::View view = view::make_view(scene, subject.tree, subject.camera, subject.sampling);
    RC_ASSERT(view.quadrics.size() == 1U);
    const view::ScreenQuadric& quadric = view.quadrics[0];
    if (quadric.kind != view::ScreenQuadricKind::roots || quadric.pixels.empty()) return;
    ++fit;
    inside += quadric.eye_inside ? 1 : 0;
    for (int i = 0; i < 10; ++i) {
      const std::int32_t x = *rc::gen::inRange(quadric.pixels.x0, quadric.pixels.x1 + 1);
      const std::int32_t y = *rc::gen::inRange(quadric.pixels.y0, quadric.pixels.y1 + 1);
      const Truth truth = truth_of(view, meet(subject, x, y));
      const Real middle = ldexp(Real(quadric.middle.a * x + quadric.middle.b * y + quadric.middle.c),
                                -static_cast<int>(subject.sampling.fraction_bits));
      const Real d =
          ldexp(Real(view::value_at(quadric.discriminant, x, y)), -static_cast<int>(quadric.discriminant_shift));
      const Real true_d = ldexp(truth.discriminant, -2 * static_cast<int>(quadric.unit));
      // The scene's quadric is rounded to doubles: relative to where it is, and to its size.
      const Real size = sqrt(abs(true_d)) + abs(truth.middle) + isa::depth_steps(subject.sampling.z_bits);
      const Real noise = size * 1e-12;
      RC_ASSERT(abs(middle - truth.middle) <= quadric.middle_error + noise);
      RC_ASSERT(abs(d - true_d) <= quadric.discriminant_error + noise * size);
    }
  };
  for (int round = 0; round < 10; ++round) CHECK(rc::check(bounded));
  MESSAGE("with roots ", fit, ", of these from inside ", inside);
  CHECK((!testing::draws_usual_cases() || fit > 600));
  CHECK((!testing::draws_usual_cases() || inside > 0));
}

namespace {

enum class Around : std::uint8_t { all_in, all_out, both };

/// What is in the shape around a place, column, row and depth, as far as that: at so many places each way, and between
/// these in depth.
Around look_around(const Subject& subject, const view::View& view, const glm::dvec3& place, const glm::dvec3& reach,
                   int steps) {
  bool is_in_somewhere = false;
  bool is_out_somewhere = false;
  for (int i = -steps; i <= steps; ++i) {
    for (int j = -steps; j <= steps; ++j) {
      const Met met = meet(subject, place.x + reach.x * i / steps, place.y + reach.y * j / steps);
      for (int k = -2 * steps; k <= 2 * steps; ++k) {
        const Real distance = distance_at(view, place.z + reach.z * k / (2 * steps));
        // Orthographic views show what is behind the eye too.
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

TEST_CASE("what the integers hold is what the shape holds, but for rounding, from every eye and on every nappe") {
  std::array<int, 4> roles{};
  int ins = 0;
  int unfit = 0;
  for (int round = 0; round < 8; ++round) {
    CHECK(rc::check([&] {
      testing::begin_round(round);
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
        // Around the place, as far as rounding may reach: all in, or all out, or it is too near to say.
        const double sideways = 2.0 * subject.sampling.edge_on_fraction + 0.02;
        const Around around = look_around(subject, view, {x, y, static_cast<double>(z)}, {sideways, sideways, step}, 1);
        if (around != (by_integers ? Around::all_out : Around::all_in)) {
          ins += around == Around::all_in ? 1 : 0;
        } else {
          // What is thinner than the places looked at are apart may be there, or be missing, between them.
          constexpr int close = 20;
          RC_ASSERT(look_around(subject, view, {x, y, static_cast<double>(z)}, {sideways, sideways, step}, close) ==
                    Around::both);
        }
        if (by_integers && z >= 1) {
          // Outside the rectangle of its own it is nothing by rule; within it the extent holds it.
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

TEST_CASE("a cylinder seen along its axis is an edge test of its circle, and from a slant far below a pixel too") {
  for (const double slant : {0.0, 1e-7}) {
    const model::Tree tree = single(model::Cylinder{4, 10, 10, false, {}}, glm::dmat4(1.0));
    const facet::Geometry scene = facet::make_geometry(tree, exact());
    view::Sampling sampling;
    sampling.width = sampling.height = 64;
    // 200 tan(11.25 degrees) / 64 model units a pixel: the axis is at column and row 31.5.
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

TEST_CASE("a sheared cylinder seen exactly from its side is no edge test, whatever rounding makes of its section") {
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

TEST_CASE("a cylinder seen from a slant of pixels is two roots again, to a unit that is less than an edge's width") {
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
    if (quadric.unit > 0) CHECK(ranges.most_root < std::int64_t{1} << 23U);
    coarse += quadric.unit > 0 ? 1 : 0;
  }
  CHECK(coarse > 0);
}

TEST_CASE("a cone whose apex is the eye is an edge test, unless both nappes are in the picture") {
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

TEST_CASE("an eye on a quadric, and a cone seen along a generator, fit no numbers") {
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

TEST_CASE("a sphere's depths and pixels are its own, not its hull's") {
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

TEST_CASE("an extent's depths hold the back of a solid too, whose depth is no longer in it") {
  const model::Tree tree = single(model::Sphere{3, {}}, glm::dmat4(1.0));
  const facet::Geometry scene = facet::make_geometry(tree, exact());
  for (const auto projection : {view::Projection::orthographic, view::Projection::perspective}) {
    view::Sampling sampling;
    sampling.width = sampling.height = 24;
    sampling.z_bits = 5;
    const view::View view = view::make_view(scene, tree, {{1, 2, 16}, {0, 0, 0}, projection}, sampling);
    const view::Extent& extent = view.extents[0];
    const view::RootRanges ranges = view::ranges_over(view.quadrics[0], sampling.fraction_bits, extent.pixels);
    CHECK(ranges.most_root > 10);
    CHECK(extent.z_high >= ranges.far.high);
    CHECK(extent.z_low <= std::max<std::int64_t>(ranges.near.low, 0));
  }
}

TEST_CASE("equal surfaces of different solids are the same integers") {
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
