#include "host/solids/hull.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <tuple>

#include "tests/support/test.h"
#include "tests/unit/solids/support.h"

using namespace csgsim;
using namespace solids;

namespace {

using Rational = boost::multiprecision::cpp_rational;

/// Side of a triangle's plane on which a point lies, exactly: positive outside.
int side_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& point) {
  Rational rows[3][3];
  const glm::dvec3* corners[] = {&b, &c, &point};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) rows[i][k] = Rational((*corners[i])[k]) - Rational(a[k]);
  }
  const Rational value = rows[0][0] * (rows[1][1] * rows[2][2] - rows[1][2] * rows[2][1]) -
                         rows[0][1] * (rows[1][0] * rows[2][2] - rows[1][2] * rows[2][0]) +
                         rows[0][2] * (rows[1][0] * rows[2][1] - rows[1][1] * rows[2][0]);
  return value.sign();
}

}  // namespace

TEST_CASE("a hull contains all of its points and its corners are among them") {
  std::mt19937_64 random(1);
  std::uniform_int_distribution<int> place(-3, 3);
  for (int round = 0; round < 20; ++round) {
    const glm::dmat3 turn = testing::random_rotation(random);
    std::vector<glm::dvec3> points;
    for (int i = 0; i < 60; ++i) points.push_back(turn * glm::dvec3(place(random), place(random), place(random)));
    const solids::Mesh mesh = hull(points);
    REQUIRE(mesh.faces.size() == 2 * mesh.points.size() - 4);
    for (const glm::dvec3& corner : mesh.points) REQUIRE(std::count(points.begin(), points.end(), corner) > 0);
    for (const auto& face : mesh.faces) {
      REQUIRE(face.size() == 3);
      for (const glm::dvec3& point : points) {
        REQUIRE(side_of(mesh.points[face[0]], mesh.points[face[1]], mesh.points[face[2]], point) <= 0);
      }
    }
  }
}

TEST_CASE("a hull does not depend on the order or addresses of its points") {
  std::mt19937_64 random(3);
  std::uniform_int_distribution<int> place(-3, 3);
  std::vector<std::vector<char>> held;
  for (int round = 0; round < 20; ++round) {
    const glm::dmat3 turn = round % 2 == 0 ? glm::dmat3(1) : testing::random_rotation(random);
    std::vector<glm::dvec3> points;
    for (int i = 0; i < 200; ++i) points.push_back(turn * glm::dvec3(place(random), place(random), place(random)));
    const solids::Mesh first = hull(points);
    CHECK(std::is_sorted(first.points.begin(), first.points.end(), [](const glm::dvec3& a, const glm::dvec3& b) {
      return std::tuple(a.x, a.y, a.z) < std::tuple(b.x, b.y, b.z);
    }));
    for (int again = 0; again < 5; ++again) {
      std::ranges::shuffle(points, random);
      // Fragments the heap with free blocks of many sizes in random order.
      for (int i = 0; i < 100; ++i) held.emplace_back(random() % 5000 + 1);
      std::ranges::shuffle(held, random);
      held.resize(held.size() / 2);
      const solids::Mesh other = hull(points);
      REQUIRE(other.points == first.points);
      REQUIRE(other.faces == first.faces);
    }
  }
}

TEST_CASE("hull triangles that are coplanar up to rounding are one face") {
  std::mt19937_64 random(2);
  for (int round = 0; round < 20; ++round) {
    const glm::dmat3 turn = testing::random_rotation(random);
    std::vector<glm::dvec3> points;
    for (int i = 0; i < 27; ++i) points.push_back(turn * glm::dvec3(i % 3, i / 3 % 3, i / 9));
    const auto piece = hull_piece(points);
    REQUIRE(piece);
    CHECK(piece->faces.size() == 6);
    CHECK(piece->points.size() == 8);
    CHECK(testing::volume_of(piece->points, piece->faces) == doctest::Approx(8).epsilon(1e-12));
  }
}

TEST_CASE("coplanar or collinear or equal or no points have an empty hull") {
  const std::vector<glm::dvec3> flat{{0, 0, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 2}, {3, 2, 5}};
  const std::vector<glm::dvec3> line{{0, 0, 0}, {1, 2, 3}, {2, 4, 6}};
  const std::vector<glm::dvec3> same{{1, 2, 3}, {1, 2, 3}};
  for (const auto& points : {flat, line, same, std::vector<glm::dvec3>{}}) {
    CHECK(hull(points).faces.empty());
    CHECK(!hull_piece(points));
  }
}

TEST_CASE("subnormal coordinates count as 0 in a hull") {
  for (const double tiny : {1e-320, -1e-320, 0x1p-1074, -0x1p-600, -0.0}) {
    CAPTURE(tiny);
    std::vector<glm::dvec3> points;
    std::vector<glm::dvec3> plain;
    for (int i = 0; i < 27; ++i) {
      const glm::dvec3 point(i % 3, i / 3 % 3, i / 9);
      plain.push_back(point);
      for (const double off : {tiny, 0.0}) points.push_back(point * 0.25 + glm::dvec3(off, 0, off));
    }
    for (glm::dvec3& point : plain) point *= 0.25;
    const solids::Mesh found = hull(points);
    CHECK(found.faces.size() == 12);
    CHECK(testing::volume_of(found.points, found.faces) == 0.125);
    CHECK(hull_piece(points)->faces.size() == 6);
    CHECK(found.faces.size() == hull(plain).faces.size());
  }
}

TEST_CASE("a hull thinner than rounding has no piece") {
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 8; ++i) points.emplace_back(i % 2, i / 2 % 2, i / 4 * 1e-14);
  CHECK(hull(points).faces.size() == 12);
  CHECK(!hull_piece(points));
}
