#include "host/swept/spine.h"

#include "host/swept/curve.h"
#include "host/swept/orientation.h"
#include "host/swept/sweep.h"
#include "tests/support/test.h"

using namespace csgsim;
using namespace swept;

namespace {

constexpr double pi = std::numbers::pi;

/// A polyline as a path.
Path make_path(const std::vector<glm::dvec3>& points, bool is_closed = false) {
  return {swept::bernstein_segments({1, is_closed, points}), is_closed, true};
}

Path smooth(const std::vector<Segment>& segments) { return {segments, false, false}; }

swept::Sweep along(const Curve& trajectory) {
  return {{1, true, {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}}, trajectory};
}

std::string spine_error(const swept::Sweep& sweep) {
  return testing::error_of([&] { const Spine spine(sweep); });
}

bool are_same(const glm::dvec3& one, const glm::dvec3& other) { return glm::distance(one, other) < 1e-9; }

glm::dvec3 up_at(const Path& path, double place) { return Orientation(path).upward(place, path.tangent(place)); }

const double half_root = std::sqrt(0.5);

}  // namespace

TEST_CASE("the slope of a segment of a path is that of its polynomial in each degree") {
  CHECK(swept::slope({0, {{{3, 4, 5}}}}, 0.5) == glm::dvec3(0));
  CHECK(swept::slope({1, {{{1, 1, 1}, {3, 0, 5}}}}, 0.25) == glm::dvec3(2, -1, 4));
  // x = t^2 and y = 2 t have slopes 2 t and 2.
  CHECK(swept::slope({2, {{{0, 0, 0}, {0, 1, 0}, {1, 2, 0}}}}, 0.25) == glm::dvec3(0.5, 2, 0));
  // x = t^3 has slope 3 t^2.
  CHECK(swept::slope({3, {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 0, 0}}}}, 0.5) == glm::dvec3(0.75, 0, 0));
}

TEST_CASE("a segment's end directions skip coincident points") {
  const glm::dvec3 a(1, 1, 1);
  const glm::dvec3 b(1, 4, 5);
  for (const Segment& segment : {Segment{1, {a, b}}, Segment{2, {a, a, b}}, Segment{2, {a, b, b}},
                                 Segment{3, {a, a, a, b}}, Segment{3, {a, b, b, b}}}) {
    CAPTURE(segment.degree);
    CHECK(are_same(smooth({segment}).leaving(0), {0, 0.6, 0.8}));
    CHECK(are_same(smooth({segment}).arriving(0), {0, 0.6, 0.8}));
  }
  const Segment bend{2, {{{0, 0, 0}, {3, 4, 0}, {3, 9, 0}}}};
  CHECK(are_same(smooth({bend}).leaving(0), {0.6, 0.8, 0}));
  CHECK(are_same(smooth({bend}).arriving(0), {0, 1, 0}));
  // The same for short steps.
  const Segment small{2, {{{0, 0, 0}, {0.3, 0.4, 0}, {0.3, 0.9, 0}}}};
  CHECK(are_same(smooth({small}).leaving(0), {0.6, 0.8, 0}));
  CHECK(are_same(smooth({small}).arriving(0), {0, 1, 0}));
  CHECK(are_same(smooth({small}).tangent(0.5), glm::normalize(glm::dvec3(0.3, 0.9, 0))));
  // Three equal points have no direction.
  for (const auto which : {0, 1}) {
    CHECK(testing::error_of([&] {
            const Path path = smooth({bend, {2, {a, a, a}}});
            static_cast<void>(which == 0 ? path.leaving(1) : path.arriving(1));
          }) == "all points of segment 2 of the trajectory coincide; remove points");
  }
}

TEST_CASE("a path's tangent bisects joints and follows the only segment at open ends") {
  const Path open = make_path({{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {4, 2, 6}});
  CHECK(are_same(open.tangent(0), {1, 0, 0}));
  CHECK(are_same(open.tangent(0.5), {1, 0, 0}));
  CHECK(are_same(open.tangent(1), {half_root, half_root, 0}));
  CHECK(are_same(open.tangent(1.25), {0, 1, 0}));
  CHECK(are_same(open.tangent(2), {0, half_root, half_root}));
  CHECK(are_same(open.tangent(3), {0, 0, 1}));
  const Path closed = make_path({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}}, true);
  CHECK(are_same(closed.tangent(0), glm::normalize(glm::dvec3(1 - half_root, -half_root, 0))));
  CHECK(are_same(closed.tangent(3), closed.tangent(0)));
  CHECK(are_same(closed.tangent(2), glm::normalize(glm::dvec3(-half_root, 1 - half_root, 0))));
  CHECK(are_same(closed.tangent(2.5), {-half_root, -half_root, 0}));
  CHECK(are_same(closed.tangent(3.5), {1, 0, 0}));
  // Half-way, x and y of t^2 and t^3 have slopes; x = (2 t - 1)^3 has none at t = 1/2.
  CHECK(are_same(smooth({{2, {{{0, 0, 0}, {0, 1, 0}, {1, 2, 0}}}}}).tangent(0.5), glm::normalize(glm::dvec3(1, 2, 0))));
  CHECK(are_same(smooth({{3, {{{-1, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {1, 0, 0}}}}}).tangent(0.5), {1, 0, 0}));
}

TEST_CASE("a trajectory whose directions are opposite within 0.02 radians is rejected") {
  // Unit directions that are opposite except for an angle a sum to length 2 sin(a / 2).
  for (const bool is_near : {true, false}) {
    const double angle = is_near ? 0.0199 : 0.0201;
    const Path path = make_path({{0, 0, 0}, {1, 0, 0}, {1 - std::cos(angle), std::sin(angle), 0}});
    CHECK(testing::error_of([&] { static_cast<void>(path.tangent(1)); }) ==
          (is_near ? "the trajectory reverses at the end of its segment 1; move that point" : ""));
  }
}

TEST_CASE("a contour's v is the y axis projected on the contour's plane") {
  CHECK(are_same(up_at(make_path({{0, 0, 0}, {5, 0, 0}}), 0.5), {0, 1, 0}));
  CHECK(are_same(up_at(make_path({{0, 0, 0}, {3, 4, 0}}), 0), {-0.8, 0.6, 0}));
  CHECK(are_same(up_at(make_path({{0, 0, 0}, {0, -4, 3}}), 1), {0, 0.6, 0.8}));
  // The limit is 5.7 degrees from the axis, where its projection has length 0.1.
  for (const double sine : {0.101, 0.099}) {
    const double cosine = std::sqrt(1 - sine * sine);
    CHECK(are_same(up_at(make_path({{0, 0, 0}, {sine, cosine, 0}}), 0.5),
                   sine > 0.1 ? glm::dvec3(-cosine, sine, 0) : glm::normalize(glm::dvec3(0, 0, -1))));
  }
}

TEST_CASE("a contour's v points to -z along the rising y axis and to z if it falls") {
  CHECK(are_same(up_at(make_path({{0, 0, 0}, {0, 5, 0}}), 0.5), {0, 0, -1}));
  CHECK(are_same(up_at(make_path({{0, 0, 0}, {0, -5, 0}}), 1), {0, 0, 1}));
  // If the path leans slightly towards z, v is -z without its component along the tangent.
  const glm::dvec3 leaning = glm::normalize(glm::dvec3(0, 1, 0.05));
  CHECK(
      are_same(up_at(make_path({{0, 0, 0}, leaning}), 0), glm::normalize(glm::dvec3(0, 0, -1) + leaning.z * leaning)));
  const Path wave = smooth({{3, {{{0, 0, 0}, {0.05, 1, 0}, {-0.05, 2, 0}, {0, 3, 0}}}}});
  CHECK(are_same(up_at(wave, 0), {0, 0, -1}));
  CHECK(are_same(up_at(wave, 1), {0, 0, -1}));
}

TEST_CASE("v at an end along the y axis is that of the nearest place with a defined v") {
  // The plane of x and y: left of the tangent where it rises to the right or falls to the left.
  CHECK(are_same(up_at(smooth({{2, {{{0, 0, 0}, {0, 5, 0}, {5, 10, 0}}}}}), 0), {-1, 0, 0}));
  CHECK(are_same(up_at(smooth({{2, {{{0, 0, 0}, {0, 5, 0}, {-5, 10, 0}}}}}), 0), {1, 0, 0}));
  CHECK(are_same(up_at(smooth({{2, {{{0, 0, 0}, {5, 5, 0}, {5, 10, 0}}}}}), 1), {-1, 0, 0}));
  CHECK(are_same(up_at(smooth({{2, {{{0, 0, 0}, {-5, 5, 0}, {-5, 10, 0}}}}}), 1), {1, 0, 0}));
  CHECK(are_same(up_at(smooth({{2, {{{0, 0, 0}, {5, -5, 0}, {5, -10, 0}}}}}), 1), {1, 0, 0}));
  // A polyline takes its orientation from the next or the previous corner.
  CHECK(are_same(up_at(make_path({{0, 0, 0}, {0, 5, 0}, {5, 5, 0}}), 0), {-1, 0, 0}));
  CHECK(are_same(up_at(make_path({{0, 0, 0}, {5, 0, 0}, {5, 5, 0}}), 2), {-1, 0, 0}));
}

TEST_CASE("a contour's v rotates evenly where a smooth tangent passes the y direction") {
  // x' / y' = 1 - 2 t, from 45 degrees to the right to 45 to the left.
  const Path arch = smooth({{2, {{{0, 0, 0}, {5, 5, 0}, {0, 10, 0}}}}});
  const double tangens = 0.1 / std::sqrt(0.99);
  const double from = (1 - tangens) / 2;
  const Orientation orientation(arch);
  for (const double part : {0.01, 0.25, 0.5, 0.75, 0.99}) {
    CAPTURE(part);
    const double place = from + part * tangens;
    const glm::dvec3 tangent = arch.tangent(place);
    const glm::dvec3 v = orientation.upward(place, tangent);
    // Left of the tangent at first, right of it at the end.
    const glm::dvec3 left(-tangent.y, tangent.x, 0);
    CHECK(glm::dot(v, left) == doctest::Approx(std::cos(part * pi)).epsilon(1e-6));
    CHECK(std::abs(v.z) == doctest::Approx(std::sin(part * pi)).epsilon(1e-6));
    CHECK(glm::dot(v, tangent) == doctest::Approx(0));
  }
  CHECK(
      are_same(up_at(arch, from - 0.001), glm::dvec3(-arch.tangent(from - 0.001).y, arch.tangent(from - 0.001).x, 0)));
  const double behind = from + tangens + 0.001;
  CHECK(are_same(up_at(arch, behind), glm::dvec3(arch.tangent(behind).y, -arch.tangent(behind).x, 0)));
}

TEST_CASE("a contour's v rotates evenly between corners along the y axis") {
  const glm::dvec3 y(0, 1, 0);
  // Both ends to the right: v is carried along without rotation. One right, one left: half of 180 degrees.
  const Path step = make_path({{-5, 0, 0}, {0, 0, 0}, {0, 5, 0}, {0, 10, 0}, {5, 10, 0}});
  CHECK(are_same(Orientation(step).upward(2, y), {-1, 0, 0}));
  CHECK(are_same(Orientation(step).upward(1.5, y), {-1, 0, 0}));
  const Path bow = make_path({{-5, 0, 0}, {0, 0, 0}, {0, 5, 0}, {0, 10, 0}, {-5, 10, 0}});
  const Orientation turned(bow);
  CHECK(std::abs(turned.upward(2, y).z) == doctest::Approx(1));
  CHECK(turned.upward(1.5, y).x == doctest::Approx(-half_root));
  CHECK(std::abs(turned.upward(1.5, y).z) == doctest::Approx(half_root));
  CHECK(turned.upward(2.5, y).x == doctest::Approx(half_root));
  // A closed trajectory, across its start.
  const Path closed = make_path({{0, 0, 0}, {0, 5, 0}, {-5, 5, 0}, {-5, -5, 0}, {0, -5, 0}}, true);
  const Orientation over(closed);
  CHECK(std::abs(over.upward(0, y).z) == doctest::Approx(1));
  CHECK(std::abs(over.upward(5, y).z) == doctest::Approx(1));
  CHECK(std::abs(over.upward(4.5, y).z) == doctest::Approx(half_root));
  CHECK(std::abs(over.upward(0.5, y).z) == doctest::Approx(half_root));
  CHECK(over.upward(4.5, y).x == doctest::Approx(-over.upward(0.5, y).x));
}

TEST_CASE("the fraction of a path's length is exact for lines and for a parabola") {
  const Spine lines(along({1, false, {{0, 0, 0}, {0, 0, 1}, {0, 0, 10}}}));
  CHECK(lines.length_fraction(0, 0) == 0);
  CHECK(lines.length_fraction(0, 0.5) == doctest::Approx(0.05));
  CHECK(lines.length_fraction(1, 0) == doctest::Approx(0.1));
  CHECK(lines.length_fraction(1, 0.5) == doctest::Approx(0.55));
  CHECK(lines.length_fraction(1, 1) == doctest::Approx(1));
  // y = x^2 up to x has length x / 2 times the root of 1 + 4 x^2, plus a quarter of arsinh 2 x.
  const Spine parabola(along({2, false, {{0, 0, 0}, {0.5, 0, 0}, {1, 1, 0}}}));
  const auto length = [](double x) { return x / 2 * std::sqrt(1 + 4 * x * x) + std::asinh(2 * x) / 4; };
  for (const double x : {0.125, 0.5, 0.75, 1.0})
    CHECK(parabola.length_fraction(0, x) == doctest::Approx(length(x) / length(1)).epsilon(1e-11));
}

TEST_CASE("a part is short within one piece of each function and 90 degrees of rotation") {
  const auto is_short = [](const Curve& rotation, const Curve& scale, double from, double to) {
    swept::Sweep sweep = along({1, false, {{0, 0, 0}, {0, 0, 8}}});
    sweep.rotation = rotation;
    sweep.scale = scale;
    return Spine(sweep).is_short(0, from, to);
  };
  const Curve none{0, false, {{0, 0, 0}}};
  const Curve one{0, false, {{1, 1, 0}}};
  const Curve two_turns{1, false, {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}};
  const Curve two_scales{1, false, {{1, 1, 0}, {2, 2, 0}, {1, 1, 0}}};
  const Curve four_scales{1, false, {{1, 1, 0}, {2, 2, 0}, {1, 1, 0}, {2, 2, 0}, {1, 1, 0}}};
  CHECK(is_short(none, one, 0, 1));
  for (const bool is_turned : {false, true}) {
    const Curve& rotation = is_turned ? two_turns : none;
    const Curve& scale = is_turned ? one : two_scales;
    CHECK(!is_short(rotation, scale, 0, 1));
    CHECK(!is_short(rotation, scale, 0.25, 0.8125));
    CHECK(is_short(rotation, scale, 0.25, 0.75));
    CHECK(is_short(rotation, scale, 0, 0.5));
  }
  CHECK(is_short(none, four_scales, 0.5, 0.75));
  CHECK(!is_short(none, four_scales, 0.5, 0.8125));
  CHECK(!is_short(two_turns, four_scales, 0, 0.5));
  // A rise to half of the height and back; its eighths contain the peak; within a part, by its own length.
  const auto parabola = [](double height) { return Curve{2, false, {{0, 0, 0}, {height, 0, 0}, {0, 0, 0}}}; };
  CHECK(is_short(parabola(89.9), one, 0, 1));
  CHECK(!is_short(parabola(90.1), one, 0, 1));
  const Curve line{1, false, {{0, 0, 0}, {180, 0, 0}}};
  CHECK(is_short(line, one, 0.25, 0.7499));
  CHECK(!is_short(line, one, 0.25, 0.7501));
}

TEST_CASE("a contour's rotation and scale change in proportion to the length along the path") {
  swept::Sweep sweep = along({1, false, {{0, 0, 0}, {0, 0, 8}}});
  sweep.rotation = {1, false, {{0, 0, 0}, {90, 0, 0}}};
  sweep.scale = {1, false, {{1, 2, 0}, {3, 4, 0}}};
  const Spine spine(sweep);
  CHECK(are_same(spine.joint(0).u, {1, 0, 0}));
  CHECK(are_same(spine.joint(0).v, {0, 2, 0}));
  CHECK(are_same(spine.joint(1).u, {0, 3, 0}));
  CHECK(are_same(spine.joint(1).v, {-4, 0, 0}));
  CHECK(spine.joint(1).origin == glm::dvec3(0, 0, 8));
  const swept::Section middle = spine.section(0, 0.5, {0, 0, 4});
  CHECK(are_same(middle.u, 2 * half_root * glm::dvec3(1, 1, 0)));
  CHECK(are_same(middle.v, 3 * half_root * glm::dvec3(-1, 1, 0)));
  CHECK(are_same(middle.at({1, 1, 0}), glm::dvec3(0, 0, 4) + middle.u + middle.v));
  CHECK(!middle.is_point());
  CHECK(swept::Section{}.is_point());
  CHECK(!swept::Section{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}.is_point());
  CHECK(!swept::Section{{0, 0, 0}, {0, 0, 0}, {0, 1, 0}}.is_point());
}

TEST_CASE("a sweep's corners are mitred and sections between them lean evenly") {
  // A corner from x to -z: v is up, u is across. At the corner the plane bisects the angle: u has length 1 / cos 45.
  const Spine spine(along({1, false, {{0, 0, 0}, {4, 0, 0}, {4, 0, -4}}}));
  const double length = std::sqrt(2.0);
  CHECK(are_same(spine.joint(0).u, {0, 0, -1}));
  CHECK(are_same(spine.joint(1).u, length * glm::dvec3(-half_root, 0, -half_root)));
  CHECK(are_same(spine.joint(2).u, {-1, 0, 0}));
  for (const std::size_t joint : {std::size_t{0}, std::size_t{1}, std::size_t{2}})
    CHECK(are_same(spine.joint(joint).v, {0, 1, 0}));
  CHECK(are_same(spine.section(0, 0.5, {2, 0, 0}).u, {-0.5, 0, -1}));
  CHECK(are_same(spine.section(1, 0.25, {4, 0, -1}).u, {-1, 0, -0.75}));
  // A corner of 60 degrees gives 1 / cos 30.
  const Spine sharp(along({1, false, {{0, 0, 0}, {4, 0, 0}, {6, 0, -2 * std::sqrt(3.0)}}}));
  CHECK(glm::length(sharp.joint(1).u) == doctest::Approx(2 / std::sqrt(3.0)));
  // A straight joint.
  const Spine straight(along({1, false, {{0, 0, 0}, {4, 0, 0}, {6, 0, 0}}}));
  CHECK(are_same(straight.joint(1).u, {0, 0, -1}));
}

TEST_CASE("a smooth trajectory with a corner above 0.001 rad at equal points is rejected") {
  // Two equal points of a curve of degree 2 form a corner: it arrives along x and leaves at an angle.
  const auto bent = [](double angle, bool is_closed) {
    const glm::dvec3 next(std::cos(angle), std::sin(angle), 0);
    Curve curve{2, is_closed, {{-1, 0, 0}, {0, 0, 0}, {0, 0, 0}, next}};
    if (is_closed) curve.points = {{0, 0, 0}, next, {0, 3, 0}, {-3, 0, 0}, {-1, 0, 0}, {0, 0, 0}};
    return spine_error(along(curve));
  };
  const auto error_at = [](int segment) {
    return "the trajectory has a corner where its segment " + std::to_string(segment) +
           " starts; move coincident points apart, or use degree 1";
  };
  CHECK(bent(0.0009, false) == "");
  CHECK(bent(0.0011, false) == error_at(2));
  CHECK(bent(1, false) == error_at(2));
  CHECK(bent(0, true) == "");
  CHECK(bent(1, true) == error_at(6));
  // The last point of a closed curve equals the one before it.
  Curve first{2, true, {{0, 0, 0}, {0, 0, 0}, {1, 1, 0}, {0, 3, 0}, {-3, 0, 0}}};
  CHECK(spine_error(along(first)) == error_at(1));
}

TEST_CASE("a closed trajectory may rotate its contour by a full turn even if a scale is 0") {
  Curve ring{2, true, {}};
  for (int i = 0; i < 8; ++i) ring.points.emplace_back(9 * std::cos(i * pi / 4), 0, 9 * std::sin(i * pi / 4));
  swept::Sweep sweep = along(ring);
  sweep.rotation = {1, false, {{0, 0, 0}, {360, 0, 0}}};
  for (const glm::dvec3& scale : {glm::dvec3(1, 1, 0), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)}) {
    sweep.scale = {0, false, {scale}};
    CHECK(spine_error(sweep) == "");
  }
  const Spine spine(sweep);
  CHECK(spine.is_closed());
  CHECK(spine.joint(8).u == spine.joint(0).u);
  CHECK(spine.joint(8).v == spine.joint(0).v);
  CHECK(spine.joint(8).origin == spine.joint(0).origin);
}