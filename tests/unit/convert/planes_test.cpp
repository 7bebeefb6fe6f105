#include <boost/multiprecision/cpp_int.hpp>

#include "sim/software/planes/unit_box.h"
#include "sim/software/planes/whole_planes.h"
#include "tests/oracle/split_mix.h"
#include "tests/support/test.h"

using namespace csgsim;
using software::WholePlanes;
using testing::Random;

namespace {

using Rational = boost::multiprecision::cpp_rational;
using Row = std::array<Rational, 4>;

Row row_of(const WholePlanes& planes, std::uint32_t plane) {
  Row row;
  for (std::size_t i = 0; i < row.size(); ++i) row[i] = Rational(planes.coefficients(plane)[i]);
  return row;
}

Rational determinant(const Row& p, const Row& q, const Row& r, const std::array<std::size_t, 3>& columns) {
  const auto [a, b, c] = columns;
  return p[a] * (q[b] * r[c] - q[c] * r[b]) - p[b] * (q[a] * r[c] - q[c] * r[a]) + p[c] * (q[a] * r[b] - q[b] * r[a]);
}

/// The intersection of three planes, by Cramer's rule.
std::array<Rational, 3> meeting(const Row& p, const Row& q, const Row& r) {
  const Rational all = determinant(p, q, r, {0, 1, 2});
  return {-determinant(p, q, r, {3, 1, 2}) / all, -determinant(p, q, r, {0, 3, 2}) / all,
          -determinant(p, q, r, {0, 1, 3}) / all};
}

Rational height(const Row& plane, const std::array<Rational, 3>& place) {
  return plane[0] * place[0] + plane[1] * place[1] + plane[2] * place[2] + plane[3];
}

double number(Random& random) {
  const double size = std::ldexp(1.0, -static_cast<int>(random.below(random.one_of<std::uint64_t>({1, 4, 30}))));
  return (2 * random.unit() - 1) * size;
}

/// A general plane, a plane across an axis, or one at a small angle to the x-axis.
facet::Plane plane(Random& random) {
  facet::Plane plane{{number(random), number(random), number(random)}, number(random) / 2};
  const std::uint64_t kind = random.below(4);
  if (kind == 0) plane.normal = {0, 0, 1};
  if (kind == 1) plane.normal = {1, number(random) * 1e-9, 0};
  return plane;
}

/// A plane through a point, as exactly as doubles allow.
facet::Plane plane_through(Random& random, const glm::dvec3& place) {
  const glm::dvec3 normal(number(random), number(random), number(random));
  return {normal, -(normal.x * place.x + normal.y * place.y + normal.z * place.z)};
}

int sign_of(const Rational& number) { return number > 0 ? 1 : number < 0 ? -1 : 0; }

const facet::Box unit_box{glm::dvec3(-0.5), glm::dvec3(0.5)};

}  // namespace

TEST_CASE("sides and positions of plane intersections match rational arithmetic") {
  Random random(7);
  int near = 0;
  for (int i = 0; i < 3000; ++i) {
    std::vector<facet::Plane> given{plane(random), plane(random), plane(random)};
    const WholePlanes first(given, unit_box);
    const std::array<Row, 3> rows{row_of(first, 0), row_of(first, 1), row_of(first, 2)};
    if (determinant(rows[0], rows[1], rows[2], {0, 1, 2}) == 0) continue;
    const std::array<Rational, 3> exactly = meeting(rows[0], rows[1], rows[2]);
    glm::dvec3 place(0);
    for (int axis = 0; axis < 3; ++axis) place[axis] = static_cast<double>(exactly[static_cast<std::size_t>(axis)]);
    if (std::abs(place.x) > 1 || std::abs(place.y) > 1 || std::abs(place.z) > 1) continue;
    for (int k = 0; k < 4; ++k) given.push_back(k % 2 == 0 ? plane(random) : plane_through(random, place));
    const WholePlanes planes(given, unit_box);
    const software::Meeting point = planes.meet(2, 0, 1);
    std::optional<WholePlanes::Point> kept;
    for (std::uint32_t k = 3; k < given.size(); ++k) {
      const Rational above = height(row_of(planes, k), exactly);
      if (abs(above) < 1e-15) ++near;
      CHECK(planes.side(point, k) == sign_of(above));
      CHECK(planes.side(point, k, kept) == sign_of(above));
      CHECK(planes.is_on_all(point.planes, std::array{k}) == (above == 0));
    }
    const glm::dvec3 rounded = software::place_of(point);
    const glm::dvec3 fine = planes.exact_position(point.planes);
    Rational off = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const Rational& coordinate = exactly[static_cast<std::size_t>(axis)];
      off += abs(Rational(rounded[axis]) - coordinate);
      CHECK(abs(Rational(fine[axis]) - coordinate) <= abs(coordinate) * Rational(0x1p-50));
    }
    CHECK(off <= Rational(software::deviation_of(point) + software::place_error));
    CHECK(software::deviation_of(point) < 0x1p-31);
  }
  CHECK(near > 1500);
}

TEST_CASE("a plane through a point has side 0 for every triple that defines the point") {
  // The planes are x = 1/8, y = 1/4, z = 3/8, x + y + z = 3/4, x - y = -1/8.
  const std::vector<facet::Plane> given{
      {{1, 0, 0}, -0.125}, {{0, 1, 0}, -0.25}, {{0, 0, 1}, -0.375}, {{1, 1, 1}, -0.75}, {{1, -1, 0}, 0.125}};
  const WholePlanes planes(given, unit_box);
  const std::array<software::Triple, 3> triples{{{0, 1, 2}, {0, 2, 3}, {2, 3, 4}}};
  for (const software::Triple& triple : triples) {
    const software::Meeting point = planes.meet(triple[0], triple[1], triple[2]);
    for (std::uint32_t i = 0; i < given.size(); ++i) CHECK(planes.side(point, i) == 0);
    CHECK(planes.exact_position(triple) == glm::dvec3(0.125, 0.25, 0.375));
  }
}
