#include "sim/judges/analytic.h"

#include <rapidcheck.h>

#include <glm/vec3.hpp>

#include "hw/isa/depth_scale.h"
#include "tests/numerics/solids.h"
#include "tests/support/test.h"
#include "tests/unit/judges/scenery.h"

using namespace csgsim;
using namespace csgsim::testing;
using view::Projection;

namespace {

constexpr Size size{40, 30};
const double to_origin = straight_distance(size.height);
constexpr double none = std::numeric_limits<double>::infinity();

/// Surface of a solid around the origin, seen along +y: the distance from the eye, or `none`, along the ray with offset
/// x to the right and z upwards from the axis. Offsets are in pixels, which are model units (at the origin, in
/// perspective).
using Surface = std::function<double(double x, double z)>;

/// The nearer root of a t^2 - 2 b t + c = 0.
double nearer(double a, double b, double c) {
  const double discriminant = b * b - a * c;
  return discriminant < 0 ? none : (b - std::sqrt(discriminant)) / a;
}

double square(double x) { return x * x; }

/// Rotates solid and camera about x and then about z, which leaves the picture unchanged.
struct Turn {
  double about_x = 0;
  double about_z = 0;
};

view::Camera turned(const view::Camera& camera, Turn turn) {
  constexpr double radians = std::numbers::pi / 180.0;
  const double x = turn.about_x * radians;
  const double z = turn.about_z * radians;
  const double away = camera.eye.y;
  return {{-away * std::cos(x) * std::sin(z), away * std::cos(x) * std::cos(z), away * std::sin(x)},
          {0, 0, 0},
          camera.projection};
}

Turn any_turn() { return {*rc::gen::inRange(-890, 890) / 10.0, *rc::gen::inRange(-1800, 1800) / 10.0}; }

/// Whether the surface does not begin or end close to the point.
bool is_clear(const Surface& surface, double x, double z) {
  constexpr double little = 1e-6;
  const bool seen = surface(x, z) < none;
  for (const double dx : {-little, little}) {
    for (const double dz : {-little, little}) {
      if ((surface(x + dx, z + dz) < none) != seen) return false;
    }
  }
  return true;
}

/// Number of pixels that do not match the formula.
std::size_t wrong(const std::string& csg, Projection projection, Turn turn, const Surface& surface) {
  const std::string placed_csg = with_transform(rotation(turn.about_x, turn.about_z), csg);
  const judges::Truth truth =
      analytic(make_scenery(placed_csg, turned(straight_camera(size.height, projection), turn), size));
  std::size_t count = 0;
  std::size_t covered = 0;
  for (std::uint32_t i = 0; i < truth.owner.size(); ++i) {
    const double x = i % size.width - (size.width - 1) / 2.0;
    const double z = (size.height - 1) / 2.0 - i / size.width;
    if (!is_clear(surface, x, z)) continue;
    const double expected = surface(x, z);
    const bool seen = truth.owner[i] != judges::nothing;
    if (seen) ++covered;
    // An infinite distance equals only itself.
    const bool right = seen ? std::abs(truth.distance[i] - expected) <= 1e-9 * to_origin : expected == none;
    if (!right) ++count;
  }
  return covered > 50 ? count : truth.owner.size();
}

void check(const std::string& csg, Projection projection, const Surface& surface) {
  CHECK(wrong(csg, projection, {}, surface) == 0);
  CHECK(rc::check([&] { RC_ASSERT(wrong(csg, projection, any_turn(), surface) == 0U); }));
}

std::string scaled(const glm::dvec3& by, const std::string& part) { return with_transform(scaling(by), part); }

}  // namespace

TEST_CASE("the analytic picture of a sphere has the distance given by Pythagoras") {
  const std::string sphere = ball({0, 0, 0}, 12.25, 5);
  check(sphere, Projection::orthographic, [](double x, double z) {
    const double depth = square(12.25) - x * x - z * z;
    return depth < 0 ? none : to_origin - std::sqrt(depth);
  });
  check(sphere, Projection::perspective, [](double x, double z) {
    return nearer(1 + square(x / to_origin) + square(z / to_origin), to_origin, square(to_origin) - square(12.25));
  });
}

TEST_CASE("the analytic picture of a scaled sphere is an ellipsoid") {
  const std::string ellipsoid = scaled({14, 3, 8}, ball({0, 0, 0}, 1, 5));
  check(ellipsoid, Projection::orthographic, [](double x, double z) {
    const double depth = 1 - square(x / 14) - square(z / 8);
    return depth < 0 ? none : to_origin - 3 * std::sqrt(depth);
  });
  check(ellipsoid, Projection::perspective, [](double x, double z) {
    return nearer(square(x / to_origin / 14) + square(z / to_origin / 8) + 1.0 / 9, to_origin / 9,
                  square(to_origin / 3) - 1);
  });
}

TEST_CASE("the analytic picture of a cylinder from the side has the depth of its circle") {
  check(cylinder({0, 0, -7.25}, 14.5, 6.25, 6.25, 3), Projection::orthographic, [](double x, double z) {
    return std::abs(z) > 7.25 || std::abs(x) > 6.25 ? none : to_origin - std::sqrt(square(6.25) - x * x);
  });
  // The ends of this cylinder are outside the picture.
  check(cylinder({0, 0, -40}, 80, 6.25, 6.25, 3), Projection::perspective, [](double x, double) {
    return nearer(1 + square(x / to_origin), to_origin, square(to_origin) - square(6.25));
  });
}

TEST_CASE("the analytic picture of a scaled cylinder from its end is a flat ellipse") {
  const std::string lying = with_transform(rotation(90, 0), scaled({2, 1, 3}, cylinder({0, 0, -1}, 2, 6.25, 6.25, 3)));
  check(lying, Projection::orthographic,
        [](double x, double z) { return square(x / 2) + z * z > square(6.25) ? none : to_origin - 3; });
  // The front hides the side in perspective.
  check(lying, Projection::perspective, [](double x, double z) {
    const double nearness = (to_origin - 3) / to_origin;
    return square(x * nearness / 2) + square(z * nearness) > square(6.25) ? none : to_origin - 3;
  });
}

TEST_CASE("the analytic picture of a cone from above slopes evenly up to a flat end") {
  // The apex points to the eye: the axis is along -y.
  const auto towards = [](const std::string& upright) { return with_transform(rotation(90, 0), upright); };
  check(towards(cylinder({0, 0, 0}, 9, 12.25, 0, 3)), Projection::orthographic, [](double x, double z) {
    const double aside = std::hypot(x, z);
    return aside > 12.25 ? none : to_origin - 9 * (1 - aside / 12.25);
  });
  check(towards(cylinder({0, 0, 0}, 9, 12.25, 4.25, 3)), Projection::orthographic, [](double x, double z) {
    const double aside = std::max(std::hypot(x, z), 4.25);
    return aside > 12.25 ? none : to_origin - 9 * (12.25 - aside) / 8;
  });
  // The ray at distance t is slope t off the axis, where the cone is 9 slope t / 12.25 behind its apex.
  check(towards(cylinder({0, 0, 0}, 9, 12.25, 0, 3)), Projection::perspective, [](double x, double z) {
    const double slope = std::hypot(x, z) / to_origin;
    const double t = (to_origin - 9) / (1 - slope * 9 / 12.25);
    return t > to_origin ? none : t;
  });
}

TEST_CASE("the analytic picture of a cone from the side has hyperbolic depth up to the apex") {
  for (const bool tip_up : {true, false}) {
    const std::string cone = tip_up ? cylinder({0, 0, -9.25}, 18.5, 8, 0, 3) : cylinder({0, 0, -9.25}, 18.5, 0, 8, 3);
    check(cone, Projection::orthographic, [&](double x, double z) {
      const double radius = 8 * (9.25 + (tip_up ? -z : z)) / 18.5;
      const bool in = std::abs(z) < 9.25 && std::abs(x) <= radius;
      return in ? to_origin - std::sqrt(square(radius) - x * x) : none;
    });
  }
}

TEST_CASE("an analytic ray steeper than a cone hits only one nappe") {
  // Seen from its base: the flat end hides the mirrored nappe beyond the apex.
  const std::string away = with_transform(rotation(-90, 0), cylinder({0, 0, 0}, 9, 12.25, 0, 3));
  check(away, Projection::orthographic, [](double x, double z) { return std::hypot(x, z) > 12.25 ? none : to_origin; });
  // The inside is visible if the cone is subtracted from a solid that ends at its base.
  const std::string dent =
      subtract({with_transform(rotation(90, 0), cylinder({0, 0, -20}, 20, 14.25, 14.25, 3)), away});
  check(dent, Projection::orthographic, [](double x, double z) {
    const double aside = std::hypot(x, z);
    if (aside > 14.25) return none;
    return aside > 12.25 ? to_origin : to_origin + 9 * (1 - aside / 12.25);
  });
}

TEST_CASE("the number of facets does not change the true picture") {
  const view::Camera camera = straight_camera(size.height, Projection::perspective);
  const judges::Truth few = analytic(make_scenery(ball({1, 2, 3}, 8, 3), camera, size));
  const judges::Truth many = analytic(make_scenery(ball({1, 2, 3}, 8, 50), camera, size));
  CHECK(few.distance == many.distance);
  CHECK(few.plane.empty());
}

TEST_CASE("intended polygons stay polygons in the true picture unless overridden") {
  // Low counts of every shape that has them, rotated so that no side is edge-on.
  const std::string nuts =
      "sphere($fn=5,$fa=12,$fs=2,r=9);"
      "multmatrix([[1,0,0,-12],[0,1,0,0],[0,0,1,0],[0,0,0,1]]){cylinder($fn=6,$fa=12,$fs=2,h=14,r1=5,r2=5,center=true);"
      "}"
      "multmatrix([[1,0,0,12],[0,1,0,0],[0,0,1,-6],[0,0,0,1]]){cylinder($fn=3,$fa=12,$fs=2,h=12,r1=6,r2=0,center=false)"
      ";}";
  for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
    const Scenery scenery = make_scenery(nuts, turned(straight_camera(size.height, projection), {23, 41}), size);
    const judges::Truth facets = exact(scenery);
    const auto truth_as = [&](const facet::Faceting& drawn_as) {
      return judges::analytic_truth(scenery.tree, drawn_as, scenery.camera, size.width, size.height,
                                    {projection == Projection::perspective, scenery.near, 1000});
    };
    const judges::Truth meant = truth_as({});
    CHECK(meant.owner == facets.owner);
    constexpr double nudge = 1e-10;  // rays are moved 1e-9 pixels off edge-on faces
    for (std::size_t i = 0; i < meant.distance.size(); ++i) {
      if (meant.owner[i] != judges::nothing)
        CHECK(meant.distance[i] == doctest::Approx(facets.distance[i]).epsilon(nudge));
    }
    const judges::Truth round = analytic(scenery);
    CHECK(round.owner != meant.owner);
    CHECK(truth_as({.tolerance = 0.1}).distance == round.distance);
    CHECK(truth_as({.fragments = 12}).distance == round.distance);
    CHECK(truth_as({.exact_curves = true}).distance == meant.distance);
    CHECK(truth_as({.min_round_sides = 3}).distance == round.distance);
  }
}

TEST_CASE("pictures for successive near planes equal those computed separately") {
  // Spheres that touch and overlap, in front of the eye, around it and behind it.
  const std::string balls =
      "difference(){sphere($fn=50,$fa=12,$fs=2,r=9);"
      "multmatrix([[1,0,0,3],[0,1,0,-7],[0,0,1,1],[0,0,0,1]]){sphere($fn=50,$fa=12,$fs=2,r=5);}}"
      "multmatrix([[1,0,0,-9],[0,1,0,-20],[0,0,1,0],[0,0,0,1]]){sphere($fn=50,$fa=12,$fs=2,r=4);}"
      "multmatrix([[1,0,0,0],[0,1,0,-75],[0,0,1,-4],[0,0,0,1]]){sphere($fn=50,$fa=12,$fs=2,r=9);}";
  for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
    const Scenery scenery = make_scenery(balls, straight_camera(size.height, projection), size);
    judges::AnalyticPictures pictures(scenery.tree, {}, scenery.camera, size.width, size.height);
    std::size_t changed = 0;
    std::vector<double> before;
    for (const double near : {1.0, 60.0, 67.5, 71.0, 75.4, 3.0, 68.0, 68.0, 200.0, 1.0}) {
      const isa::DepthScale depth{projection == Projection::perspective, near, 1000};
      const judges::Truth alone =
          judges::analytic_truth(scenery.tree, {}, scenery.camera, size.width, size.height, depth);
      const judges::Truth& truth = pictures.truth(depth);
      CHECK(truth.distance == alone.distance);
      CHECK(truth.owner == alone.owner);
      changed += truth.distance != before ? 1U : 0U;
      before = truth.distance;
    }
    CHECK(changed == (projection == Projection::perspective ? 9U : 1U));
  }
}
