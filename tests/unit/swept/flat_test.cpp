#include "host/swept/flat.h"

#include "host/swept/net.h"
#include "tests/support/test.h"
#include "tests/unit/swept/support.h"

using namespace csgsim;

namespace {

using Corners = std::array<glm::dvec3, 4>;

struct FlatCase {
  Corners corners;
  glm::dvec3 middle;
  bool is_flat;
};

bool is_flat(const FlatCase& one) {
  swept::SubdivisionCounts counts;
  return swept::is_flat(one.corners, one.middle, 0.125, counts);
}

/// A net of one patch over u and v from -1/2 to 1/2, with height `by_v(v)` times u^2 - 1/4: of degree 2 in u, with
/// control points u^2 - 1/3 - 1/4, and in v by its own control points. `is_turned` exchanges u and v.
swept::Net bent_net(const std::array<double, 4>& by_v, bool is_turned) {
  constexpr std::array<double, 4> places{-1.5, -0.5, 0.5, 1.5};
  swept::Net net;
  for (std::size_t row = 0; row < 4; ++row) {
    std::vector<glm::dvec3>& points = net.rows.emplace_back();
    for (std::size_t column = 0; column < 4; ++column) {
      const std::size_t u = is_turned ? row : column;
      const std::size_t v = is_turned ? column : row;
      points.emplace_back(places[column], places[row], by_v[v] * (places[u] * places[u] - 1.0 / 3 - 0.25));
    }
  }
  return net;
}

std::size_t leaves_of(const swept::Net& net, const swept::Accuracy& accuracy) {
  return swept_test::leaves_of(*swept::make_surface(net), 0, 0, accuracy).size();
}

}  // namespace

TEST_CASE("a point's distance from a line is limited by the line's ends") {
  struct Row {
    glm::dvec3 point;
    glm::dvec3 from;
    glm::dvec3 to;
    double off;
  };
  for (const Row& row : std::vector<Row>{{{2, 3, 0}, {0, 0, 0}, {4, 0, 0}, 3},
                                         {{-3, 4, 0}, {0, 0, 0}, {4, 0, 0}, 5},
                                         {{-1, 0, 0}, {0, 0, 0}, {4, 0, 0}, 1},
                                         {{5, 0, 0}, {0, 0, 0}, {4, 0, 0}, 1},
                                         {{7, 4, 0}, {0, 0, 0}, {4, 0, 0}, 5},
                                         {{4, 3, 5}, {1, 1, 1}, {1, 5, 1}, 5},
                                         {{4, 6, 2}, {1, 2, 2}, {1, 2, 2}, 5}}) {
    CAPTURE(row.point.x);
    CHECK(swept::distance_to_segment(row.point, row.from, row.to) == doctest::Approx(row.off));
  }
}

TEST_CASE("a point's distance from a plane uses the longest line for collinear points") {
  using Three = std::array<glm::dvec3, 3>;
  const Three level{{{0, 0, 1}, {4, 0, 1}, {0, 2, 1}}};
  CHECK(swept::distance_to_plane({7, 9, 4}, level) == doctest::Approx(3));
  CHECK(swept::distance_to_plane({7, 9, -2}, level) == doctest::Approx(3));
  // x + y + z = 3, from (3, 3, 3).
  CHECK(swept::distance_to_plane({3, 3, 3}, {{{3, 0, 0}, {0, 3, 0}, {0, 0, 3}}}) ==
        doctest::Approx(6 / std::sqrt(3.0)));
  // Points on the x axis from 0 to 4, in each order of the three: 3 above its end, 2 behind it.
  for (const Three& line : {Three{{{0, 0, 0}, {4, 0, 0}, {2, 0, 0}}}, Three{{{0, 0, 0}, {2, 0, 0}, {4, 0, 0}}},
                            Three{{{4, 0, 0}, {2, 0, 0}, {0, 0, 0}}}, Three{{{2, 0, 0}, {0, 0, 0}, {4, 0, 0}}},
                            Three{{{2, 0, 0}, {4, 0, 0}, {0, 0, 0}}}, Three{{{0, 0, 0}, {4, 0, 0}, {4, 0, 0}}}}) {
    CAPTURE(line[0].x);
    CAPTURE(line[1].x);
    CHECK(swept::distance_to_plane({4, 3, 0}, line) == doctest::Approx(3));
    CHECK(swept::distance_to_plane({6, 0, 0}, line) == doctest::Approx(2));
    CHECK(swept::distance_to_plane({-2, 0, 0}, line) == doctest::Approx(2));
  }
}

TEST_CASE("three points are collinear if their triangle is 1e-9 as high as long") {
  // The point is in the plane z = 0; it is 5 off the line.
  const auto off = [](const glm::dvec3& one, const glm::dvec3& other) {
    return swept::distance_to_plane({0, 5, 0}, {{{0, 0, 0}, one, other}});
  };
  CHECK(off({1, 0, 0}, {1, 2e-9, 0}) == 0);
  CHECK(off({1, 0, 0}, {1, 0.5e-9, 0}) == doctest::Approx(5));
  // Twice the area is 1e-4, compared with the square of the longer side: 1e-9 times 1e6.
  CHECK(off({1, 0, 0}, {1000, 1e-4, 0}) == doctest::Approx(5));
  CHECK(off({1000, 1e-4, 0}, {1, 0, 0}) == doctest::Approx(5));
  CHECK(off({1, 0, 0}, {1000, 2e-3, 0}) == 0);
}

TEST_CASE("an element is flat if its middle and tip are within the tolerance of a plane") {
  for (const FlatCase& one :
       std::vector<FlatCase>{{{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0.125}}}, {2, 2, 0}, true},
                             {{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0.126}}}, {2, 2, 0}, false},
                             {{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}}}, {2, 2, -0.125}, true},
                             {{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}}}, {2, 2, -0.126}, false},
                             // 0.11 below the plane of three corners is 0.16 below that of the other three.
                             {{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0.1}}}, {3, 3, -0.11}, true},
                             // A tip in the south, in the west, in the north and in the east.
                             {{{{0, 0, 0}, {0, 0, 0}, {0, 4, 0}, {4, 4, 0}}}, {2, 2, 0.125}, true},
                             {{{{0, 0, 0}, {0, 0, 0}, {0, 4, 0}, {4, 4, 0}}}, {2, 2, 0.126}, false},
                             {{{{0, 0, 0}, {4, 0, 0}, {0, 0, 0}, {4, 4, 0}}}, {2, 2, 0.125}, true},
                             {{{{0, 0, 0}, {4, 0, 0}, {0, 0, 0}, {4, 4, 0}}}, {2, 2, 0.126}, false},
                             {{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 4, 0}}}, {2, 2, 0.125}, true},
                             {{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 0, 0}}}, {2, 2, 0.126}, false}}) {
    CAPTURE(one.corners[3].z);
    CAPTURE(one.middle.z);
    CHECK(is_flat(one) == one.is_flat);
  }
}

TEST_CASE("a bent side divides a patch by the side test but not by the thesis's plane test") {
  // Heights at the sides of v: control points v^2 - 1/3 - v/2 give v (v - 1/2), which is 1/2 in the south and 0 in the
  // north and in the middle. Times u^2 - 1/4, at most 1/4, the side is 1/8 of the factor off its line; the corners and
  // the middle are not.
  for (const bool is_turned : {false, true}) {
    for (const bool is_mirrored : {false, true}) {
      CAPTURE(is_turned);
      CAPTURE(is_mirrored);
      std::array<double, 4> by_v{};
      for (std::size_t i = 0; i < 4; ++i) {
        const double v = (is_mirrored ? 1.5 : -1.5) + (is_mirrored ? -1.0 : 1.0) * static_cast<double>(i);
        by_v[i] = 0.8 * (v * v - 1.0 / 3 - v / 2);
      }
      const swept::Net net = bent_net(by_v, is_turned);
      CHECK(leaves_of(net, {0.1001}) == 1);
      CHECK(leaves_of(net, {0.0999}) > 1);
      CHECK(leaves_of(net, {0.0999, swept::Flatness::plane}) == 1);
    }
  }
}

TEST_CASE("a patch is halved at most twelve times by default and sixteen on request") {
  const auto halved = [](const swept::Accuracy& accuracy) {
    return testing::error_of([&] { leaves_of(bent_net({1, 0, 0, 0}, false), accuracy); });
  };
  const swept::Accuracy usual;
  CHECK(usual.tolerance == 0.1);
  CHECK(usual.flatness == swept::Flatness::sides);
  CHECK(halved({0}).find("after 12 halvings") != std::string::npos);
  CHECK(halved({0, swept::Flatness::sides, 16}).find("after 16 halvings") != std::string::npos);
  CHECK(halved({0, swept::Flatness::sides, 20}).find("after 16 halvings") != std::string::npos);
  CHECK(halved({0, swept::Flatness::sides, 0}).find("after 0 halvings") != std::string::npos);
}