#include "tests/numerics/solids.h"
#include "tests/support/test.h"
#include "tests/unit/judges/scenery.h"

using namespace csgsim;
using namespace csgsim::testing;
using namespace judges;
using view::Projection;

namespace {

/// Pixel centres are at integer distances from the middle.
constexpr Size odd{9, 7};
constexpr std::uint32_t middle = 3 * 9 + 4;
constexpr unsigned fine = 64;

std::string round(const glm::dvec3& centre, double radius) { return ball(centre, radius, fine); }

/// A frustum along the view from y = low to y = high.
std::string along_view(double low, double high, double low_radius, double high_radius, double x = 0) {
  return with_transform("[[1,0,0," + std::to_string(x) + "],[0,0,1,0],[0,1,0,0],[0,0,0,1]]",
                        cylinder({0, 0, low}, high - low, low_radius, high_radius, fine));
}

Truth straight_on(const std::string& csg, Projection projection = Projection::orthographic, double near = 1) {
  return exact(make_curved_scenery(csg, straight_camera(odd.height, projection), odd, near));
}

/// Distance behind the origin of the surface at the pixel x to the right and z above the middle; NaN for background.
double behind(const Truth& truth, int x, int z) {
  const auto at = static_cast<std::size_t>(static_cast<int>(middle) + x - z * static_cast<int>(odd.width));
  return truth.owner[at] == nothing ? NAN : truth.distance[at] - straight_distance(odd.height);
}

bool empty(const Truth& truth) {
  for (const std::uint32_t owner : truth.owner) {
    if (owner != nothing) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("a sphere covers the pixel centres in its outline at its own depths") {
  const Truth truth = straight_on(round({0, 0, 0}, 2.5));
  CHECK(owners(truth) ==
        ".........\n"
        "...000...\n"
        "..00000..\n"
        "..00000..\n"
        "..00000..\n"
        "...000...\n"
        ".........\n");
  for (int x = -2; x <= 2; ++x) {
    for (int z = -1; z <= 1; ++z) {
      CHECK(behind(truth, x, z) == doctest::Approx(-std::sqrt(6.25 - x * x - z * z)).epsilon(1e-13));
    }
  }
}

TEST_CASE("a ray exactly on an outline sees nothing of the solid") {
  CHECK(owners(straight_on(round({2, 0, 0}, 2))) ==
        ".........\n"
        ".........\n"
        ".....000.\n"
        ".....000.\n"
        ".....000.\n"
        ".........\n"
        ".........\n");
  const Truth both = straight_on(unite({round({2, 0, 0}, 2), round({-4, 0, 0}, 4)}));
  CHECK(both.owner[middle] == nothing);
  CHECK(both.owner[middle + 1] == 0);
  CHECK(both.owner[middle - 1] == 1);
  // The left side of the upright cylinder is in the middle column.
  CHECK(straight_on(cylinder({2, 0, -2}, 4, 2, 2, fine)).owner[middle] == nothing);
  CHECK(straight_on(cylinder({2, 0, -2}, 4, 2.0000000000000004, 2.0000000000000004, fine)).owner[middle] == 0);
}

TEST_CASE("touching spheres have no intersection and subtract nothing") {
  const std::string before = round({0, -2, 0}, 2);
  const std::string after = round({0, 2, 0}, 2);
  CHECK(empty(straight_on(intersect({before, after}))));
  CHECK(straight_on(subtract({before, after})).owner == straight_on(before).owner);
  const Truth taken = straight_on(subtract({after, before}));
  CHECK(taken.owner == straight_on(after).owner);
  CHECK(behind(taken, 0, 0) == doctest::Approx(0).scale(1));
}

TEST_CASE("a subtracted sphere touching the surface from inside shows its back") {
  const Truth truth = straight_on(subtract({round({0, 0, 0}, 4), round({0, -2, 0}, 2)}));
  CHECK(truth.owner[middle] == 1);
  CHECK(behind(truth, 0, 0) == doctest::Approx(0).scale(1));
  CHECK(truth.owner[middle + 3] == 0);
}

TEST_CASE("a sphere touching a face shows the first in tree order") {
  const std::string wall = box({-4.5, 0, -3.5}, {4.5, 1, 3.5});
  const std::string touching = round({0, 2, 0}, 2);
  const Truth first = straight_on(unite({touching, wall}));
  for (std::uint32_t i = 0; i < first.owner.size(); ++i) CHECK(first.owner[i] == (i == middle ? 0 : 1));
  const Truth last = straight_on(unite({wall, touching}));
  for (const std::uint32_t owner : last.owner) CHECK(owner == 0);
}

TEST_CASE("coincident quadrics follow the rules of coincident faces") {
  const std::string outer = cylinder({0, 0, -2.5}, 5, 3, 3, fine);
  CHECK(empty(straight_on(subtract({outer, outer}))));
  const Truth shared = straight_on(intersect({outer, cylinder({0, 0, -9}, 18, 3, 3, fine)}));
  CHECK(shared.owner == straight_on(outer).owner);
  CHECK(straight_on(unite({outer, outer})).owner == straight_on(outer).owner);
  // The plug fills the bore: nothing between them is visible from the side or along the axis.
  const std::string bore = along_view(-2, 2, 1.5, 1.5);
  const std::string plugged = unite({subtract({along_view(-2, 2, 3, 3), bore}), bore});
  const Truth truth = straight_on(plugged);
  for (std::uint32_t i = 0; i < truth.owner.size(); ++i) {
    if (truth.owner[i] != nothing) CHECK(truth.distance[i] == doctest::Approx(straight_distance(odd.height) - 2));
  }
}

TEST_CASE("a cylinder along the view contains the rays in its surface") {
  const Truth truth = straight_on(along_view(-1, 1, 2, 2, 2));
  CHECK(truth.owner[middle] == 0);
  CHECK(truth.owner[middle - 1] == nothing);
  CHECK(behind(truth, 0, 0) == doctest::Approx(-1));
  // A subtracted cylinder removes them.
  CHECK(straight_on(subtract({box({-4.5, 0, -3.5}, {4.5, 1, 3.5}), along_view(-1, 2, 2, 2, 2)})).owner[middle] ==
        nothing);
}

TEST_CASE("a cone's apex is visible if it points to the eye but not on its outline") {
  const Truth pointing = straight_on(along_view(-3, 1, 0, 2.5));
  CHECK(behind(pointing, 0, 0) == doctest::Approx(-3));
  CHECK(behind(pointing, 1, 0) == doctest::Approx(-3 + 4 / 2.5));
  CHECK(behind(pointing, 1, 2) == doctest::Approx(-3 + 4 / 2.5 * std::sqrt(5.0)));
  const Truth upright = straight_on(cylinder({0, 0, -2}, 2, 2, 0, fine));
  CHECK(upright.owner[middle] == nothing);
  CHECK(upright.owner[middle - 9] == nothing);
  CHECK(behind(upright, 0, -1) == doctest::Approx(-1));
  const Truth away = straight_on(along_view(-1, 3, 2.5, 0));
  CHECK(behind(away, 0, 0) == doctest::Approx(-1));
  // Inside a subtracted cone the existing nappe is visible from behind.
  const Truth taken = straight_on(subtract({along_view(-1, 9, 4, 4), along_view(-1, 3, 2.5, 0)}));
  CHECK(behind(taken, 1, 0) == doctest::Approx(3 - 4 / 2.5));
  CHECK(behind(taken, 0, 0) == doctest::Approx(3));
}

TEST_CASE("rays along a cone's generator meet it once") {
  // The cone is x^2 <= Z Y for a point (x, Y, Z), between two planes.
  const std::string leaning =
      with_transform("[[1,0,0,0],[0,1,1,0],[0,-1,1,0],[0,0,0,1]]", cylinder({0, 0, 0}, 2, 0, 2, fine));
  const Truth truth = straight_on(leaning);
  for (int x = -3; x <= 3; ++x) {
    for (int z = -3; z <= 3; ++z) {
      // The ray at z <= 0 passes the cone, lies in its surface, or meets the other nappe.
      const double front = z > 0 ? static_cast<double>(x * x) / z : NAN;
      CAPTURE(x);
      CAPTURE(z);
      if (std::abs(front - (4 - z)) < 1e-9) continue;
      if (front < 4 - z) CHECK(behind(truth, x, z) == doctest::Approx(front).scale(1));
      if (!(front < 4 - z)) CHECK(std::isnan(behind(truth, x, z)));
    }
  }
}

TEST_CASE("a cone with its apex at the eye covers the rays in its surface") {
  const view::Camera camera{{0, -16, 0}, {0, 0, 0}, Projection::perspective};
  const auto seen = [&](const std::string& csg) { return exact(make_curved_scenery(csg, camera, odd, 1)); };
  // A cone along the view, as wide as the picture is high and completely cut by the near plane.
  const Truth round_cone = seen(along_view(-16, 0, 0, 16 * view::half_height_per_distance()));
  CHECK(owners(round_cone) ==
        "...000...\n"
        "..00000..\n"
        ".0000000.\n"
        ".0000000.\n"
        ".0000000.\n"
        "..00000..\n"
        "...000...\n");
  for (std::uint32_t i = 0; i < round_cone.owner.size(); ++i) {
    if (round_cone.owner[i] != nothing) CHECK(round_cone.distance[i] == doctest::Approx(1));
  }
  // The view direction is a generator: the cone is above the middle row and includes one ray of it.
  const Truth leaning =
      seen(with_transform("[[1,0,0,0],[0,1,1,-16],[0,-1,1,0],[0,0,0,1]]", cylinder({0, 0, 0}, 8, 0, 8, fine)));
  CHECK(leaning.owner[middle] == 0);
  CHECK(leaning.owner[middle + 1] == nothing);
  CHECK(leaning.owner[middle - 9] == 0);
  CHECK(leaning.owner[middle + 9] == nothing);
}

TEST_CASE("a sphere behind the eye is invisible in perspective but not orthographically") {
  const double eye = straight_distance(odd.height);
  const std::string back = round({0, -eye - 5, 0}, 2.5);
  CHECK(empty(straight_on(back, Projection::perspective)));
  CHECK(straight_on(back).owner == straight_on(round({0, 0, 0}, 2.5)).owner);
}

TEST_CASE("a sphere around the eye is capped and a subtracted one shows its back") {
  const double eye = straight_distance(odd.height);
  const Truth capped = straight_on(round({0, -eye, 0}, 5), Projection::perspective, 2);
  for (std::uint32_t i = 0; i < capped.owner.size(); ++i) {
    CHECK(capped.owner[i] == 0);
    CHECK(capped.plane[i] == 0);  // the near cap, since the model has no planes
    CHECK(capped.distance[i] == doctest::Approx(2));
  }
  const Truth hollow =
      straight_on(subtract({box({-40, -40, -40}, {40, 40, 40}), round({0, -eye, 0}, 5)}), Projection::perspective, 2);
  CHECK(hollow.owner[middle] == 1);
  CHECK(hollow.plane[middle] == 6 + 1);
  CHECK(hollow.distance[middle] == doctest::Approx(5));
}

TEST_CASE("an eye on a sphere's surface sees the far side at one depth per ray") {
  const view::Camera camera{{0, -16, 0}, {0, 0, 0}, Projection::perspective};
  const std::string model = subtract({box({-40, -40, -40}, {40, 40, 40}), round({0, -11, 0}, 5)});
  const Truth truth = exact(make_curved_scenery(model, camera, odd, 1));
  CHECK(truth.owner[middle] == 1);
  CHECK(truth.distance[middle] == doctest::Approx(10));
  const double slope = 3 * 2 * view::half_height_per_distance() / odd.height;
  CHECK(truth.distance[middle + 3] == doctest::Approx(10 / (1 + slope * slope)));
}

TEST_CASE("a visible quadric is identified by its number and root") {
  const Truth truth = straight_on(subtract({round({0, 0, 0}, 3), round({0, -3, 0}, 1.5)}));
  CHECK(truth.plane[middle] == 1 + 2 * 1 + 1);
  CHECK(truth.plane[middle + 2] == 1);
  CHECK(truth.plane[0] == nothing);
}
