#include "tests/numerics/solids.h"
#include "tests/support/test.h"
#include "tests/unit/judges/scenery.h"

using namespace csgsim;
using namespace csgsim::testing;
using namespace judges;
using view::Projection;

namespace {

constexpr Size even{8, 6};
constexpr Size odd{7, 5};

Truth straight_on(const std::string& csg, Size size, Projection projection = Projection::orthographic,
                  double near = 1) {
  return exact(make_scenery(csg, straight_camera(size.height, projection), size, near));
}

/// Whether every covered pixel lies `behind` model units behind the centre of the picture.
bool all_at(const Truth& truth, double behind) {
  const double expected = straight_distance(truth.height) + behind;
  for (std::size_t i = 0; i < truth.owner.size(); ++i) {
    const bool seen = truth.owner[i] != nothing;
    if (seen != std::isfinite(truth.distance[i])) return false;
    if (seen && std::abs(truth.distance[i] - expected) > 1e-13 * expected) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("a frontal box covers the pixel centres inside it at the distance of its front") {
  const Truth truth = straight_on(box({-3, -1, -2}, {2, 5, 1}), even);
  CHECK(owners(truth) ==
        "........\n"
        "........\n"
        ".00000..\n"
        ".00000..\n"
        ".00000..\n"
        "........\n");
  CHECK(all_at(truth, -1));
}

TEST_CASE("a through hole with flush ends shows what is behind it") {
  const std::string holed = subtract({box({-3, -1, -2}, {3, 1, 2}), box({-1, -1, -1}, {2, 1, 1})});
  CHECK(owners(straight_on(holed, even)) ==
        "........\n"
        ".000000.\n"
        ".00...0.\n"
        ".00...0.\n"
        ".000000.\n"
        "........\n");
  CHECK(owners(straight_on(unite({holed, box({-4, 4, 0}, {4, 5, 3})}), even)) ==
        "22222222\n"
        "20000002\n"
        "20022202\n"
        ".00...0.\n"
        ".000000.\n"
        "........\n");
}

TEST_CASE("the bottom of a hole belongs to the subtracted primitive at its back") {
  const Truth truth = straight_on(subtract({box({-3, -1, -2}, {3, 9, 2}), box({-5, -5, -5}, {5, 4, 5})}), even);
  CHECK(owners(truth) ==
        "........\n"
        ".111111.\n"
        ".111111.\n"
        ".111111.\n"
        ".111111.\n"
        "........\n");
  CHECK(all_at(truth, 4));
}

TEST_CASE("a shared surface belongs to the first primitive in tree order") {
  const std::string wide = box({-4, 0, -1}, {4, 1, 1});
  const std::string high = box({-1, 0, -3}, {1, 2, 3});
  CHECK(owners(straight_on(unite({wide, high}), even)) ==
        "...11...\n"
        "...11...\n"
        "00000000\n"
        "00000000\n"
        "...11...\n"
        "...11...\n");
  CHECK(owners(straight_on(unite({high, wide}), even)) ==
        "...00...\n"
        "...00...\n"
        "11100111\n"
        "11100111\n"
        "...00...\n"
        "...00...\n");
}

TEST_CASE("touching solids have no intersection and subtract nothing") {
  const std::string before = box({-3, -2, -2}, {3, 0, 2});
  const std::string behind = box({-3, 0, -2}, {3, 2, 2});
  const std::string none = owners(straight_on(subtract({before, before}), even));
  CHECK(none.find('0') == std::string::npos);
  CHECK(owners(straight_on(intersect({before, behind}), even)) == none);
  CHECK(owners(straight_on(subtract({before, behind}), even)) == owners(straight_on(before, even)));
  CHECK(owners(straight_on(subtract({behind, before}), even)) == owners(straight_on(behind, even)));
}

TEST_CASE("pixel centres on an edge-on face belong to the solid to the right or below") {
  const std::string four = unite({box({-1.5, 0, 0}, {0, 1, 1.5}), box({0, 0, 0}, {1.5, 1, 1.5}),
                                  box({-1.5, 0, -1.5}, {0, 1, 0}), box({0, 0, -1.5}, {1.5, 1, 0})});
  CHECK(owners(straight_on(four, odd)) ==
        ".......\n"
        "..011..\n"
        "..233..\n"
        "..233..\n"
        ".......\n");
}

TEST_CASE("a solid across the near plane is capped with a separate plane") {
  const Scenery scenery =
      make_scenery(box({-50, -50, -50}, {50, 3, 50}), straight_camera(6, Projection::perspective), even, 2);
  const Truth truth = exact(scenery);
  for (std::size_t i = 0; i < truth.owner.size(); ++i) {
    CHECK(truth.owner[i] == 0);
    CHECK(truth.distance[i] == doctest::Approx(2).epsilon(1e-15));
    CHECK(truth.plane[i] == scenery.scene.planes.planes().size());
  }
}

TEST_CASE("a face in the near plane is not cut") {
  const view::Camera camera{{0, -4, 0}, {0, 0, 0}, Projection::perspective};
  const Scenery scenery = make_scenery(box({-9, -3, -9}, {9, 3, 9}), camera, even, 1);
  const Truth truth = exact(scenery);
  for (const std::uint32_t plane : truth.plane) CHECK(plane < scenery.scene.planes.planes().size());
}

TEST_CASE("an eye inside a subtracted solid sees its back") {
  const std::string hollow = subtract({box({-50, -50, -50}, {50, 50, 50}), box({-40, -40, -40}, {40, 3, 40})});
  const Truth truth = straight_on(hollow, even, Projection::perspective);
  for (const std::uint32_t owner : truth.owner) CHECK(owner == 1);
  CHECK(all_at(truth, 3));
  const Truth behind = straight_on(box({-50, -50, -50}, {50, -20, 50}), even, Projection::perspective);
  for (const std::uint32_t owner : behind.owner) CHECK(owner == nothing);
}

TEST_CASE("a perspective picture of a box has the right distance and size") {
  // Two pixels are one unit at half the distance of the origin.
  const double front = -straight_distance(6) / 2;
  const Truth truth = straight_on(box({-1, front, -0.5}, {1.5, 3, 1}), even, Projection::perspective);
  CHECK(owners(truth) ==
        "........\n"
        "..00000.\n"
        "..00000.\n"
        "..00000.\n"
        "........\n"
        "........\n");
  CHECK(all_at(truth, front));
}

TEST_CASE("an empty model is background everywhere") {
  const model::Tree tree;
  const Truth truth = exact({tree, facet::make_geometry(tree), straight_camera(even.height), even.width, even.height});
  for (const std::uint32_t owner : truth.owner) CHECK(owner == nothing);
  CHECK(all_at(truth, 0));
}
