#include "host/swept/net.h"

#include <rapidcheck.h>

#include "host/swept/flat.h"
#include "tests/support/test.h"
#include "tests/unit/swept/support.h"

using namespace csgsim;
using namespace csgsim::swept_test;

namespace {

double distance_to_triangle(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  // Distance to the nearest point of a lattice on it: coarse, but independent of the judged code.
  constexpr int steps = 12;
  double nearest = glm::distance(p, a);
  for (int i = 0; i <= steps; ++i) {
    for (int k = 0; i + k <= steps; ++k) {
      const glm::dvec3 q = a + (b - a) * (static_cast<double>(i) / steps) + (c - a) * (static_cast<double>(k) / steps);
      nearest = std::min(nearest, glm::distance(p, q));
    }
  }
  return nearest;
}

}  // namespace

TEST_CASE("corners of a patch's elements are points of the surface") {
  CHECK(rc::check([] {
    const swept::Net net = random_net(5, 6, 20);
    const auto surface = swept::make_surface(net);
    RC_ASSERT(surface->columns() == 3U);
    RC_ASSERT(surface->rows() == 2U);
    for (std::size_t row = 0; row < 2; ++row) {
      for (std::size_t column = 0; column < 3; ++column) {
        for (const swept::Element& leaf : leaves_of(*surface, column, row, {0.5})) {
          for (std::uint32_t corner = 0; corner < 4; ++corner) {
            const double u = static_cast<double>(leaf.square.x + (corner % 2) * leaf.square.size);
            const double v = static_cast<double>(leaf.square.y + (corner >> 1U) * leaf.square.size);
            const glm::dvec3 expected = by_basis(net, static_cast<double>(column) + u / swept::whole_side,
                                                 static_cast<double>(row) + v / swept::whole_side);
            RC_ASSERT(glm::distance(leaf.corners[corner], expected) < 1e-10);
          }
        }
      }
    }
  }));
}

TEST_CASE("a patch's leaves cover it in Morton order from south-west to north-east") {
  CHECK(rc::check([] {
    const auto surface = swept::make_surface(random_net(4, 4, 40));
    double covered = 0;
    std::uint64_t last = 0;
    bool is_first = true;
    for (const swept::Element& leaf : leaves_of(*surface, 0, 0, {0.2})) {
      covered += static_cast<double>(leaf.square.size) * leaf.square.size;
      std::uint64_t morton = 0;
      for (std::uint32_t bit = 0; bit < swept::max_depth; ++bit)
        morton |= static_cast<std::uint64_t>((leaf.square.x >> bit) & 1U) << (2 * bit) |
                  static_cast<std::uint64_t>((leaf.square.y >> bit) & 1U) << (2 * bit + 1);
      RC_ASSERT(is_first || morton > last);
      last = morton;
      is_first = false;
    }
    RC_ASSERT(covered == static_cast<double>(swept::whole_side) * swept::whole_side);
  }));
}

TEST_CASE("points of a net's surface are within 1.5 tolerances of their element") {
  CHECK(rc::check([] {
    const swept::Net net = random_net(4, 4, 20);
    const auto surface = swept::make_surface(net);
    constexpr double tolerance = 0.2;
    for (const swept::Element& leaf : leaves_of(*surface, 0, 0, {tolerance})) {
      for (const double u : {0.25, 0.5, 0.8}) {
        for (const double v : {0.1, 0.5, 0.6}) {
          const double size = leaf.square.size;
          const glm::dvec3 point = by_basis(net, (leaf.square.x + u * size) / swept::whole_side,
                                            (leaf.square.y + v * size) / swept::whole_side);
          const auto& c = leaf.corners;
          const double coarse = std::max(glm::distance(c[0], c[3]), glm::distance(c[1], c[2])) / 12;
          const double off =
              std::min(distance_to_triangle(point, c[0], c[1], c[2]), distance_to_triangle(point, c[3], c[1], c[2]));
          RC_ASSERT(off < 1.5 * tolerance + coarse);
        }
      }
    }
  }));
}

TEST_CASE("an element is flat if its fourth corner and midpoint are near the others' plane") {
  swept::SubdivisionCounts counts;
  const auto is_flat = [&](double fourth, double middle) {
    return swept::is_flat({{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, fourth}}}, {2, 2, middle}, 0.1, counts);
  };
  CHECK(is_flat(0.09, -0.09));
  CHECK(!is_flat(0.11, 0.0275));
  CHECK(!is_flat(0, -0.11));
  CHECK(counts.tests == 6);
  // Two corners are equal: the plane is that of the other three.
  CHECK(!swept::is_flat({{{0, 0, 0}, {0, 0, 0}, {0, 4, 0}, {4, 4, 0}}}, {2, 2, 0.11}, 0.1, counts));
  CHECK(swept::is_flat({{{0, 0, 0}, {0, 0, 0}, {0, 4, 0}, {4, 4, 0}}}, {2, 2, 0.09}, 0.1, counts));
}

TEST_CASE("a tolerance that the levels of subdivision cannot reach is rejected") {
  const auto surface = swept::make_surface({{{{0, 0, 0}, {1, 0, 9}, {2, 0, 0}, {3, 0, 9}},
                                             {{0, 1, 0}, {1, 1, 0}, {2, 1, 9}, {3, 1, 0}},
                                             {{0, 2, 9}, {1, 2, 0}, {2, 2, 0}, {3, 2, 0}},
                                             {{0, 3, 0}, {1, 3, 9}, {2, 3, 0}, {3, 3, 5}}}});
  CHECK(testing::error_of([&] {
          leaves_of(*surface, 0, 0, {1e-6, swept::Flatness::sides, 3});
        }) ==
        "a surface is not within 1e-06 of its elements after 3 halvings; use a coarser tolerance, or a "
        "smoother curve");
}

TEST_CASE("a net with too few or unequally long rows of points is rejected") {
  CHECK(swept::validation_error(swept::Net{}) == "a patch needs at least 4 rows of points, not 0");
  const std::vector<glm::dvec3> row(4);
  CHECK(swept::validation_error(swept::Net{{row, row, row, {}}}) == "a row of a patch needs at least 4 points, not 0");
  CHECK(swept::validation_error(swept::Net{{row, row, row, std::vector<glm::dvec3>(5)}}) ==
        "rows of a patch have 4 and 5 points; make them equally long");
  CHECK(swept::validation_error(swept::Net{{row, row, row, row}}) == "");
}