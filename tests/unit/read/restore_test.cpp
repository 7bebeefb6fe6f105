#include "host/read/restore.h"

#include <rapidcheck.h>

#include <glm/matrix.hpp>

#include "host/facet/geometry.h"
#include "host/read/read.h"
#include "tests/support/test.h"

namespace reader = csgsim::read;

namespace {

using Exact = glm::mat<3, 3, long double>;

/// A rotation about an axis in more digits than doubles have.
Exact turn_about(int axis, int hundredths) {
  const long double radians = hundredths * std::numbers::pi_v<long double> / 18000;
  const int next = (axis + 1) % 3;
  const int last = (axis + 2) % 3;
  Exact turn(1);
  turn[next][next] = turn[last][last] = std::cos(radians);
  turn[next][last] = std::sin(radians);
  turn[last][next] = -std::sin(radians);
  return turn;
}

Exact turned(int x, int y, int z) { return turn_about(2, z) * turn_about(1, y) * turn_about(0, x); }

Exact scaling(double x, double y, double z) {
  Exact scale(1);
  scale[0][0] = x;
  scale[1][1] = y;
  scale[2][2] = z;
  return scale;
}

/// Returns the number after printing it to a stream and reading it back.
double in_digits(long double number) {
  const double entry = std::abs(number) < 1e-17L ? 0.0 : static_cast<double>(number);
  return std::strtod(fmt::format("{:g}", entry).c_str(), nullptr);
}

glm::dmat4 written(const Exact& matrix) {
  glm::dmat4 all(1);
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) all[column][row] = in_digits(matrix[column][row]);
  }
  return all;
}

/// Largest error of an entry; infinite for a matrix that is not restored.
double max_error(const Exact& matrix) {
  const std::optional<glm::dmat4> found = reader::restored(written(matrix));
  if (!found) return std::numeric_limits<double>::infinity();
  long double most = 0;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) most = std::max(most, std::abs((*found)[column][row] - matrix[column][row]));
  }
  return static_cast<double>(most);
}

int hundredths() { return *rc::gen::inRange(-36000, 36001); }

/// Half a unit of the sixth digit.
double half_unit(double written) {
  return written == 0.0 ? 0.0 : 0.5 * std::pow(10.0, std::floor(std::log10(std::abs(written))) - 5.0);
}

constexpr const char* null_difference =
    "difference() { multmatrix([[-0.5,-0.866025,0,0],[0.866025,-0.5,0,0],[0,0,1,0],[0,0,0,1]]) { cube(10); }"
    "multmatrix([[0.5,-0.866025,0,0],[0.866025,0.5,0,0],[0,0,1,0],[0,0,0,1]]) {"
    "multmatrix([[0.866025,-0.5,0,0],[0.5,0.866025,0,0],[0,0,1,0],[0,0,0,1]]) {"
    "multmatrix([[0.866025,-0.5,0,0],[0.5,0.866025,0,0],[0,0,1,0],[0,0,0,1]]) { cube(10); } } } }";

}  // namespace

TEST_CASE("rotations by hundredths of a degree are restored from six digits to 1e-15") {
  CHECK(rc::check([] { RC_ASSERT(max_error(turned(hundredths(), hundredths(), hundredths())) <= 1e-15); }));
}

// Here the products of sines in doubles lose more than 1e-15 if each angle is rounded first.
TEST_CASE("rotations are restored to 1e-15 where rounding the angles would lose more") {
  constexpr int angles[][3] = {{-28516, -10315, -27566}, {7809, -23263, -28909}, {-10184, -29496, -9116},
                               {31959, -4716, 26472},    {8284, -25166, -28009}, {7759, 10792, 16528},
                               {7384, -26886, 16678},    {-9654, 9458, -30942},  {-27334, -25581, -18734}};
  for (const auto& [x, y, z] : angles) CHECK(max_error(turned(x, y, z)) <= 1e-15);
}

TEST_CASE("rotations at or next to gimbal lock are restored to 1e-15") {
  CHECK(rc::check([] {
    const int right = *rc::gen::element(9000, -9000, 27000);
    RC_ASSERT(max_error(turned(hundredths(), right, hundredths())) <= 1e-15);
    RC_ASSERT(max_error(turned(hundredths(), right + *rc::gen::element(1, -1), hundredths())) <= 1e-15);
  }));
}

TEST_CASE("a rotation before or after a scale or mirror is restored to 1e-14") {
  CHECK(rc::check([] {
    const auto factor = [] { return *rc::gen::inRange(1, 1000) / 100.0 * *rc::gen::element(1, -1); };
    const Exact scale = scaling(factor(), factor(), factor());
    const Exact turn = turned(hundredths(), hundredths(), hundredths());
    RC_ASSERT(max_error(turn * scale) <= 1e-14);
    RC_ASSERT(max_error(scale * turn) <= 1e-14);
  }));
}

TEST_CASE("a restored matrix has the six written digits within half a unit of the last") {
  CHECK(rc::check([] {
    const auto turn = [] { return *rc::gen::inRange(-3'600'000, 3'600'001); };
    // Angles in ten-thousandths of a degree; few are recognized.
    const auto about = [](int axis, int fine) {
      Exact whole = turn_about(axis, fine / 100);
      const long double rest = fine % 100 * std::numbers::pi_v<long double> / 1'800'000;
      const int next = (axis + 1) % 3;
      const int last = (axis + 2) % 3;
      Exact small(1);
      small[next][next] = small[last][last] = std::cos(rest);
      small[next][last] = std::sin(rest);
      small[last][next] = -std::sin(rest);
      return whole * small;
    };
    const glm::dmat4 before = written(about(2, turn()));
    const std::optional<glm::dmat4> after = reader::restored(before);
    if (!after) return;
    for (int column = 0; column < 3; ++column) {
      for (int row = 0; row < 3; ++row) {
        RC_ASSERT(std::abs((*after)[column][row] - before[column][row]) <= half_unit(before[column][row]) + 1e-15);
      }
    }
  }));
}

TEST_CASE("a matrix without recognized angles stays as written") {
  CHECK_FALSE(reader::restored(written(turn_about(2, 3333) * turn_about(0, 1234) * turn_about(2, 1111))));
  for (const double angle : {360.0 / 7.0, 33.333, 0.004}) {
    const double radians = angle * std::numbers::pi / 180.0;
    glm::dmat4 turn(1);
    turn[0][0] = turn[1][1] = in_digits(std::cos(radians));
    turn[0][1] = in_digits(std::sin(radians));
    turn[1][0] = -turn[0][1];
    CHECK_FALSE(reader::restored(turn));
  }
  glm::dmat4 sheared(1);
  sheared[1][0] = 0.5;
  CHECK_FALSE(reader::restored(sheared));
  glm::dmat4 more_digits = written(turn_about(0, 3000));
  more_digits[1][1] = 0.86602;
  CHECK_FALSE(reader::restored(more_digits));
  CHECK_FALSE(reader::restored(glm::dmat4(0)));
}

TEST_CASE("an old release's rounded cosine of a right angle counts as zero") {
  glm::dmat4 turn = written(turn_about(2, 9000));
  turn[0][0] = turn[1][1] = 6.12323e-17;
  const std::optional<glm::dmat4> found = reader::restored(turn);
  REQUIRE(found);
  CHECK((*found)[0] == glm::dvec4(0, 1, 0, 0));
}

TEST_CASE("a translation next to a rotation stays as written") {
  glm::dmat4 matrix = written(turned(3000, 0, 1234));
  matrix[3] = {0.333333, 2, 3, 1};
  CHECK(reader::restored(matrix).value()[3] == matrix[3]);
}

TEST_CASE("equally oriented solids share planes once their rotations are restored") {
  const auto planes = [](const reader::Options& options) {
    return csgsim::facet::make_geometry(reader::read_csg_text(null_difference, "m.csg", options))
        .planes.planes()
        .size();
  };
  CHECK(planes({}) > 6);
  CHECK(planes({.restores_rotations = true}) == 6);
}
