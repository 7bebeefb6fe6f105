#include "tests/numerics/hard_case.h"
#include "tests/numerics/solids.h"
#include "tests/support/test.h"

using namespace csgsim::testing;

namespace {

constexpr Projection orthographic = Projection::orthographic;
constexpr Projection perspective = Projection::perspective;

/// A few solids that share faces and overlap.
std::vector<std::string> solids() {
  return {box({0, 0, 0}, {10, 8, 6}), box({10, 0, 0}, {14, 8, 4}), cylinder({5, 4, 0}, 6, 3, 3, 12),
          ball({9, 7, 5}, 4, 10), with_transform(rotation(20, 40), box({2, -3, -1}, {9, 4, 5}))};
}

std::vector<csgsim::view::Camera> cameras() {
  std::vector<csgsim::view::Camera> all;
  for (const Projection projection : {orthographic, perspective}) {
    all.push_back({{36, -44, 29}, {5.1, 4.2, 3.3}, projection});
    all.push_back({{5, -60, 3}, {5, 4, 3}, projection});
    all.push_back({{5, 4, 70}, {5, 4, 3}, projection});
  }
  return all;
}

/// Checks that both models give the same, correct depths at every pixel. The depth scale is fitted to the model's box,
/// so both models must have the same box.
void check_same_geometry(const std::string& a, const std::string& b) {
  std::uint64_t covered = 0;
  for (const csgsim::view::Camera& camera : cameras()) {
    const csgsim::observe::Frame one = picture_of(a, camera);
    CHECK(same_depths(one, picture_of(b, camera)));
    covered += covered_pixels(one, 20);
    look(b, camera);
  }
  CHECK(covered > 1000);
}

/// A box around everything, for complements.
const std::string world = box({-40, -40, -40}, {40, 40, 40});

std::string complement(const std::string& part) { return subtract({world, part}); }

}  // namespace

TEST_CASE("the order of a union's operands does not change the geometry") {
  std::vector<std::string> parts = solids();
  const std::string first = unite(parts);
  std::reverse(parts.begin(), parts.end());
  check_same_geometry(first, unite(parts));
  std::rotate(parts.begin(), parts.begin() + 2, parts.end());
  check_same_geometry(first, unite(parts));
}
TEST_CASE("the order of an intersection's operands does not change the geometry") {
  std::vector<std::string> parts{box({0, 0, 0}, {10, 8, 6}), ball({5, 4, 3}, 5, 16), cylinder({5, 4, 0}, 6, 5, 4, 9)};
  const std::string first = intersect(parts);
  std::reverse(parts.begin(), parts.end());
  check_same_geometry(first, intersect(parts));
  std::swap(parts[0], parts[1]);
  check_same_geometry(first, intersect(parts));
}
TEST_CASE("the order of subtracted solids does not change the geometry") {
  std::vector<std::string> parts = solids();
  const std::string first = subtract(parts);
  std::reverse(parts.begin() + 1, parts.end());
  check_same_geometry(first, subtract(parts));
}
TEST_CASE("the complement of a complement is the solid") {
  const std::string body = subtract(solids());
  check_same_geometry(intersect({world, body}), intersect({body, world}));
  const std::string twice = intersect({box({0, 0, 0}, {10, 8, 6}), complement(complement(body))});
  check_same_geometry(intersect({box({0, 0, 0}, {10, 8, 6}), body}), twice);
}
TEST_CASE("A minus B is A intersected with the complement of B") {
  const std::string a = unite({box({0, 0, 0}, {10, 8, 6}), box({10, 0, 0}, {14, 8, 4})});
  const std::string b = unite({ball({9, 7, 5}, 4, 10), cylinder({5, 4, 0}, 6, 3, 3, 12)});
  check_same_geometry(subtract({a, b}), intersect({a, complement(b)}));
}
TEST_CASE("complements of unions and intersections obey de Morgan's laws") {
  const std::string a = box({0, 0, 0}, {10, 8, 6});
  const std::string b = ball({9, 7, 5}, 4, 10);
  const std::string c = cylinder({5, 4, 0}, 6, 3, 3, 12);
  check_same_geometry(subtract({a, unite({b, c})}), intersect({subtract({a, b}), subtract({a, c})}));
  check_same_geometry(unite({subtract({a, b}), subtract({a, c})}), intersect({a, subtract({a, intersect({b, c})})}));
}
TEST_CASE("intersection distributes over union") {
  const std::string a = cylinder({5, 4, 0}, 6, 5, 4, 9);
  const std::string b = box({0, 0, 0}, {5, 8, 6});
  const std::string c = box({5, 0, 0}, {10, 8, 4});
  check_same_geometry(intersect({unite({b, c}), a}), unite({intersect({b, a}), intersect({c, a})}));
}
TEST_CASE("a solid split by a plane and united again is the solid") {
  const std::string body =
      subtract({unite({box({0, 0, 0}, {10, 8, 6}), ball({9, 7, 5}, 4, 10)}), cylinder({5, 4, 0}, 6, 3, 3, 12)});
  const std::string near_half = box({-40, -40, -40}, {4, 40, 40});
  check_same_geometry(body, unite({intersect({body, near_half}), subtract({body, near_half})}));
  const std::string slanted = with_transform(rotation(31, 17), box({-60, -60, -60}, {60, 60, 2}));
  check_same_geometry(body, unite({intersect({body, slanted}), subtract({body, slanted})}));
}
TEST_CASE("the two parts of a split solid do not intersect") {
  const std::string a = unite(solids());
  const std::string b = with_transform(rotation(31, 17), box({-60, -60, -60}, {60, 60, 2}));
  for (const csgsim::view::Camera& camera : cameras()) {
    CHECK(look(intersect({intersect({a, b}), subtract({a, b})}), camera).covered == 0);
  }
}
TEST_CASE("moving a model by whole pixels moves its picture by whole pixels") {
  // A number of model units per pixel, in an orthographic picture along an axis.
  const Look how;
  const double pixel = 2.0 * std::tan(11.25 * std::numbers::pi / 180.0) * 64.0 / how.sampling.height;
  const csgsim::view::Camera camera{{0.123, -64, 0.045}, {0.123, 0, 0.045}, orthographic};
  const std::string body = subtract(solids());
  const csgsim::observe::Frame here = picture_of(body, camera);
  CHECK(covered_pixels(here, 20) > 300);
  for (const auto& [columns, rows] : std::vector<std::pair<int, int>>{{7, 0}, {0, -11}, {-13, 9}}) {
    const std::string moved = with_transform(translation({columns * pixel, 0, -rows * pixel}), body);
    look(moved, camera);
    const csgsim::observe::Frame there = picture_of(moved, camera);
    std::uint64_t different = 0;
    for (int y = 15; y < 80; ++y) {
      for (int x = 20; x < 105; ++x) {
        const auto at = [&](int column, int row) {
          return static_cast<std::size_t>(row) * here.width + static_cast<std::size_t>(column);
        };
        const bool same_owner = here.owner[at(x, y)] == there.owner[at(x + columns, y + rows)];
        const auto a = static_cast<std::int64_t>(here.depth[at(x, y)]);
        const auto b = static_cast<std::int64_t>(there.depth[at(x + columns, y + rows)]);
        if (!same_owner || std::abs(a - b) > 1) ++different;
      }
    }
    CHECK(different == 0);
  }
}
TEST_CASE("a model and its mirror image give mirrored pictures") {
  const std::string body = subtract(solids());
  const std::string mirrored = with_transform("[[-1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]", body);
  for (const Projection projection : {orthographic, perspective}) {
    const csgsim::observe::Frame here = picture_of(body, {{3.3, -64, 2.1}, {3.3, 0, 2.1}, projection});
    const csgsim::observe::Frame there = picture_of(mirrored, {{-3.3, -64, 2.1}, {-3.3, 0, 2.1}, projection});
    std::uint64_t different = 0;
    for (std::size_t i = 0; i < here.owner.size(); ++i) {
      const std::size_t row = i / here.width;
      const std::size_t column = i % here.width;
      if (here.owner[i] != there.owner[row * here.width + (here.width - 1 - column)]) ++different;
    }
    CHECK(different == 0);
    CHECK(covered_pixels(here, 20) > 300);
  }
}
TEST_CASE("a copy of a solid elsewhere in the tree changes nothing") {
  const std::string body = subtract(solids());
  check_same_geometry(body, unite({body, body}));
  check_same_geometry(body, intersect({body, body}));
  check_same_geometry(body, subtract({body, subtract({body, body})}));
}
