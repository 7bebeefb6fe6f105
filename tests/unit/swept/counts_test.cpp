#include "host/swept/curve.h"
#include "host/swept/net.h"
#include "host/swept/surface.h"
#include "host/swept/sweep.h"
#include "hw/base/work.h"
#include "tests/support/test.h"
#include "tests/unit/swept/support.h"

using namespace csgsim;
using namespace swept;

namespace {

// Operation counts by hand, in additions (including halvings), products, quotients and roots. The normal of three
// points and its length take two differences of points, a cross product (6 products, 3 additions) and a dot product (3
// and 2); the tolerance is multiplied by the length; then each of two points takes a difference and a dot product.
constexpr Arithmetic flat_price{2 * 3 + 3 + 2 + 2 * (3 + 2), 6 + 3 + 1 + 2 * 3, 0, 1};
// A point compared with a line: two differences of points, two dot products, their quotient, the difference from the
// nearest point (3 products), its square, and the comparison with the tolerance.
constexpr Arithmetic line_price{2 * 3 + 2 * 2 + 3 + 2 + 1, 2 * 3 + 3 + 3, 1, 0};
// A contour point in a section: the origin plus two axes times a number each.
constexpr Arithmetic point_price{6, 6, 0, 0};
constexpr Arithmetic section_price{40, 60, 6, 2};

/// Halving a curve computes degree (degree + 1) / 2 points, each coordinate by an addition and a halving.
Arithmetic halving_cost(std::uint64_t degree, std::uint64_t coordinates) {
  return {degree * (degree + 1) / 2 * coordinates * 2, 0, 0, 0};
}

Arithmetic times(std::uint64_t count, const Arithmetic& price) {
  Arithmetic sum;
  for (std::uint64_t i = 0; i < count; ++i) sum += price;
  return sum;
}

Arithmetic sum_of(const std::vector<Arithmetic>& parts) {
  Arithmetic sum;
  for (const Arithmetic& part : parts) sum += part;
  return sum;
}

void check_equal(const Arithmetic& counted, const Arithmetic& expected) {
  CHECK(counted.adds == expected.adds);
  CHECK(counted.products == expected.products);
  CHECK(counted.quotients == expected.quotients);
  CHECK(counted.roots == expected.roots);
}

SubdivisionCounts counts_of(swept::Surface& surface, std::size_t column, const swept::Accuracy& accuracy) {
  SubdivisionCounts counts;
  const std::unique_ptr<swept::Stream> stream = surface.subdivide(column, 0, accuracy, counts);
  while (stream->next()) {
  }
  return counts;
}

/// A surface of height u v / 2: its fourth corner is 1/2 off the plane of the others, that of a quarter 1/8.
swept::Net saddle() {
  swept::Net net;
  for (int row = 0; row < 4; ++row) {
    std::vector<glm::dvec3>& points = net.rows.emplace_back();
    for (int column = 0; column < 4; ++column)
      points.emplace_back(10.0 * column, 10.0 * row, 0.5 * (column - 1) * (row - 1));
  }
  return net;
}

Curve straight(std::uint32_t degree) {
  Curve curve{degree, false, {}};
  for (std::uint32_t i = 0; i <= degree; ++i) curve.points.emplace_back(0, 0, 10.0 * i / degree);
  return curve;
}

Curve round(std::uint32_t degree) {
  Curve curve{degree, true, {}};
  for (int i = 0; i < 8; ++i)
    curve.points.emplace_back(3 * std::cos(i * std::numbers::pi / 4), 3 * std::sin(i * std::numbers::pi / 4), 0);
  return curve;
}

Curve square_of_two() { return {1, true, {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}}; }

}  // namespace

TEST_CASE("a net patch takes the hand-counted operations for one and for five nodes") {
  // A middle halves five cubics of three coordinates each. Two points are compared with a plane, and two inner
  // coefficients of each side with a line.
  const Arithmetic middle = times(5, halving_cost(3, 3));
  struct Row {
    double tolerance;
    swept::Flatness flatness;
    std::uint64_t nodes;
    std::uint64_t elements;
    std::uint64_t lines;
    std::uint64_t halvings;
  };
  for (const Row& row :
       {Row{1, swept::Flatness::sides, 1, 1, 8, 0}, Row{1, swept::Flatness::plane, 1, 1, 0, 0},
        Row{0.25, swept::Flatness::sides, 5, 4, 32, 3}, Row{0.25, swept::Flatness::plane, 5, 4, 0, 3}}) {
    CAPTURE(row.nodes);
    CAPTURE(row.lines);
    const auto surface = swept::make_surface(saddle());
    const Work work(1'000'000'000);
    const SubdivisionCounts counts = counts_of(*surface, 0, {row.tolerance, row.flatness, 12, work});
    CHECK(counts.nodes == row.nodes);
    CHECK(counts.elements == row.elements);
    CHECK(counts.points == 5 * row.nodes);  // four corners and the middle
    CHECK(counts.tests == 2 * row.nodes + row.lines);
    CHECK(counts.halvings == row.halvings);
    CHECK(counts.sections == 0);
    // A halving splits four cubics.
    check_equal(counts.arithmetic, sum_of({times(row.nodes, middle), times(row.nodes, flat_price),
                                           times(row.lines, line_price), times(4 * row.halvings, halving_cost(3, 3))}));
    CHECK(work.done() == 100 * row.nodes);
  }
}

TEST_CASE("the degrees of contour and trajectory set the operations of a sweep's element") {
  for (std::uint32_t degree = 1; degree <= 3; ++degree) {
    for (std::uint32_t along = 1; along <= 3; ++along) {
      CAPTURE(degree);
      CAPTURE(along);
      const auto surface = swept::make_surface(swept::Sweep{round(degree), straight(along)});
      const SubdivisionCounts counts = counts_of(*surface, 0, {100});
      CHECK(counts.nodes == 1);
      CHECK(counts.elements == 1);
      // The points of a contour's two inner coefficients in two sections, the middles of two sides, and the
      // trajectory's own.
      const std::uint64_t lines = 2 * (degree - 1) + 2 + (along - 1);
      CHECK(counts.tests == 2 + lines);
      CHECK(counts.points == 4 + 1 + 2);
      CHECK(counts.halvings == 0);
      CHECK(counts.sections == 0);
      check_equal(counts.arithmetic, sum_of({times(5 + 2, point_price), flat_price, times(lines, line_price)}));
      const SubdivisionCounts plane = counts_of(*surface, 0, {100, swept::Flatness::plane});
      CHECK(plane.tests == 2);
      CHECK(plane.points == 5);
      check_equal(plane.arithmetic, sum_of({times(5, point_price), flat_price}));
    }
  }
}

TEST_CASE("halving a sweep patch halves contour and trajectory once for all patches") {
  // An eighth of the contour is some 0.2 off its chord, half of it a quarter of that.
  for (std::uint32_t degree = 2; degree <= 3; ++degree) {
    for (std::uint32_t along = 1; along <= 3; ++along) {
      CAPTURE(degree);
      CAPTURE(along);
      const auto surface = swept::make_surface(swept::Sweep{round(degree), straight(along)});
      for (const bool is_first : {true, false}) {
        CAPTURE(is_first);
        const Work work(1'000'000'000);
        const SubdivisionCounts counts = counts_of(*surface, is_first ? 0 : 1, {0.1, swept::Flatness::plane, 12, work});
        CHECK(counts.nodes == 5);
        CHECK(counts.elements == 4);
        CHECK(counts.points == 5 * 5);
        CHECK(counts.tests == 2 * 5);
        CHECK(counts.halvings == (is_first ? 2 : 1));
        CHECK(counts.sections == (is_first ? 2 : 0));
        std::vector<Arithmetic> parts{times(5 * 5, point_price), times(5, flat_price), halving_cost(degree, 2)};
        if (is_first) {
          parts.push_back(halving_cost(along, 3));
          parts.push_back(times(2, section_price));
        }
        check_equal(counts.arithmetic, sum_of(parts));
        CHECK(work.done() == 5 * 100 + (is_first ? 2 * 2000 : 0));
      }
      // A repeated request takes no operations.
      CHECK(counts_of(*surface, 0, {0.1, swept::Flatness::plane}).halvings == 0);
    }
  }
}

TEST_CASE("a twisted side has four elements if a quarter's deviation is acceptable") {
  // Rotated by 0.1, the fourth corner is 2 sin 0.1 = 0.2 off the plane of the others, that of a quarter 0.05.
  swept::Sweep sweep{square_of_two(), straight(1)};
  sweep.rotation = {1, false, {{0, 0, 0}, {18 / std::numbers::pi, 0, 0}}};
  const auto surface = swept::make_surface(sweep);
  const SubdivisionCounts counts = counts_of(*surface, 0, {0.1});
  CHECK(counts.nodes == 5);
  CHECK(counts.elements == 4);
  CHECK(counts.points == 5 * 5 + 4 * 2);
  CHECK(counts.tests == 5 * 2 + 4 * 2);
  check_equal(counts.arithmetic, sum_of({times(25 + 8, point_price), times(5, flat_price), times(8, line_price),
                                         halving_cost(1, 2), halving_cost(1, 3), times(2, section_price)}));
}

TEST_CASE("halves a trajectory that swings to both sides, though its middle is on the chord") {
  // Its inner coefficients may be off by 4/3 of the tolerance.
  for (const double off : {0.13, 0.14}) {
    const Curve swing{3, false, {{0, 0, 0}, {off, 0, 10.0 / 3}, {-off, 0, 20.0 / 3}, {0, 0, 10}}};
    const auto surface = swept::make_surface(swept::Sweep{square_of_two(), swing});
    const SubdivisionCounts counts = counts_of(*surface, 0, {0.1});
    CAPTURE(off);
    CHECK((counts.elements == 1) == (off < 0.4 / 3));
    CHECK(counts_of(*surface, 0, {0.1, swept::Flatness::plane}).elements == 1);
  }
}
