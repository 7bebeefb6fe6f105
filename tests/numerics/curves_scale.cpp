#include "tests/numerics/curved_case.h"
#include "tests/numerics/solids.h"
#include "tests/support/test.h"

using namespace csgsim::testing;

namespace {

/// Size of a pixel in model units, in a picture of the usual size seen from 40 units.
constexpr double pixel = 0.48;

}  // namespace

TEST_CASE("ellipsoids scaled along an axis by 1/1000 to 1000 are drawn correctly") {
  for (const double factor : {1e-3, 1e-2, 0.1, 10.0, 1e2, 1e3}) {
    CAPTURE(factor);
    // Seen edge-on, a solid thinner than a tenth of a pixel is too steep for the machine's number formats.
    const CurvedLook how = factor < 0.1 || factor > 100 ? lenient : CurvedLook{};
    look_at_all(with_transform(scaling({factor, 1, 1}), ball({0, 0, 0}, 4)), how);
    look_at_all(with_transform(rotation(31, 17), with_transform(scaling({1, 1, factor}), ball({0, 0, 0}, 4))));
  }
}
TEST_CASE("ellipsoids scaled by 1/1000 one way and by 1000 another are drawn correctly") {
  look_at_all(with_transform(scaling({1e-3, 1, 1e3}), ball({0, 0, 0}, 4)), lenient);
  look_at_all(with_transform(rotation(31, 17), with_transform(scaling({1e-3, 1, 1e3}), ball({0, 0, 0}, 4))), lenient);
  look_at_all(with_transform(rotation(31, 17), with_transform(scaling({1e3, 1e-3, 1}), ball({0, 0, 0}, 4))), lenient);
}
TEST_CASE("models of 2^-20 and of 2^20 units are drawn as a model of one unit") {
  const std::string model = subtract({unite({ball({0, 0, 0}, 4), rod({0, 0, 0}, 8, 2)}), ball({2, -3, 2}, 2)});
  for (const double factor : {0x1p-20, 0x1p20}) look_at_all(with_transform(scaling(glm::dvec3(factor)), model));
}
TEST_CASE("balls between 0.001 and 1 pixel are drawn in place or omitted") {
  for (const double radius : {1e-3, 1e-2, 0.1, 0.5, 1.0}) {
    CAPTURE(radius);
    const std::string frame = box({-8, 4, -6}, {8, 5, 6});
    std::vector<std::string> parts{frame};
    for (int i = 0; i < 24; ++i) {
      const int row = i / 6;
      const glm::dvec3 place{(i % 6 - 2.5) * 2.3, 0, (row - 1.5) * 2.7};
      parts.push_back(ball(place, radius * pixel));
    }
    look_both_ways(unite(parts), {1, -40, 2}, {0, 0, 0});
    look_both_ways(subtract(parts), {1, -40, 2}, {0, 0, 0});
  }
}
TEST_CASE("a ball of 0.001 pixels at a pixel's centre is visible at that pixel") {
  const std::string csg = unite({box({-8, 4, -6}, {8, 5, 6}), ball({0, 0, 0}, 1e-3 * pixel)});
  const CurvedVerdict verdict = look_both_ways(csg, {0, -40, 0}, {0, 0, 0});
  CHECK(verdict.covered > 200);
}
TEST_CASE("wires between 0.001 and 1 pixel thick are drawn correctly") {
  for (const double radius : {1e-3, 1e-2, 0.1, 1.0}) {
    CAPTURE(radius);
    const std::string wire = rod({0, 0, -12}, 24, radius * pixel);
    look_both_ways(unite({wire, with_transform(rotation(47, 20), wire)}), {0, -40, 0}, {0, 0, 0}, lenient);
    look_both_ways(subtract({box({-8, -2, -6}, {8, 2, 6}), wire, with_transform(rotation(47, 20), wire)}), {0, -40, 0},
                   {0, 0, 0}, lenient);
  }
}
TEST_CASE("the picture's sides clip balls with radii of up to 10000 pixels") {
  for (const double radius : {1e2, 1e3, 1e4}) {
    CAPTURE(radius);
    const double r = radius * pixel;
    const std::string ground = intersect({ball({0, 0, -r}, r), box({-20, -20, -40}, {20, 20, 40})});
    look_both_ways(ground, {10, -40, 20}, {0, 0, 0}, lenient);
    look_both_ways(subtract({box({-10, -10, -10}, {10, 10, 0}), ball({0, 0, r - 4}, r)}), {10, -40, 20}, {0, 0, 0},
                   lenient);
  }
}
TEST_CASE("a ball of 10000 pixels fills the picture") {
  CurvedLook how;
  how.near = 10;
  const CurvedVerdict verdict =
      look_curved(ball({0, 0, 0}, 1e4 * pixel), {{0, -5e3, 0}, {0, 0, 0}, Projection::perspective}, how);
  CHECK(verdict.covered == 41 * 33);
}
TEST_CASE("cylinders with radii of up to 10000 pixels are drawn correctly") {
  for (const double radius : {1e2, 1e3, 1e4}) {
    CAPTURE(radius);
    const double r = radius * pixel;
    const std::string wave =
        intersect({with_transform(rotation(90, 0), rod({0, -r, -20}, 40, r)), box({-20, -20, -40}, {20, 20, 40})});
    look_both_ways(wave, {10, -40, 20}, {0, 0, 0}, lenient);
  }
}
TEST_CASE("frustums with radii that differ by 0.1 to 1e-9 are drawn correctly") {
  for (const double part : {0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9}) {
    CAPTURE(part);
    const std::string frustum = cylinder({0, 0, -6}, 12, 4, 4 * (1 - part));
    look_at_all(frustum, lenient);
    look_at_all(subtract({box({-5, -5, -5}, {5, 5, 5}), with_transform(rotation(20, 10), frustum)}), lenient);
  }
}
TEST_CASE("cones as thin as needles or as flat as discs are drawn correctly") {
  for (const double radius : {1e-2, 0.1, 100.0, 1000.0}) {
    CAPTURE(radius);
    const std::string cone = cylinder({0, 0, -6}, 12, radius, 0);
    look_both_ways(intersect({cone, box({-9, -9, -9}, {9, 9, 9})}), {10, -40, 20}, {0, 0, 0}, lenient);
  }
}
TEST_CASE("flat ellipsoids seen edge-on are drawn correctly") {
  const std::string coin = with_transform(scaling({1, 1, 1e-3}), ball({0, 0, 0}, 6));
  look_both_ways(coin, {0, -40, 0}, {0, 0, 0}, lenient);
  look_both_ways(coin, {0, -40, 0.01}, {0, 0, 0}, lenient);
  look_both_ways(with_transform(scaling({1, 1, 20}), coin), {0, -40, 0}, {0, 0, 0});
  look_both_ways(subtract({box({-8, -8, -4}, {8, 8, 4}), coin, box({-9, -9, 0}, {9, 0, 5})}), {0, -40, 10}, {0, 0, 0});
}
TEST_CASE("curved solids 2^20 units from the origin are drawn correctly") {
  const glm::dvec3 far{0x1p20, -0x1p19, 0x1p18};
  const std::string csg = with_transform(translation(far), subtract({ball({0, 0, 0}, 6), rod({0, 0, -8}, 16, 2)}));
  look_both_ways(csg, far + glm::dvec3(20, -30, 10), far);
}
TEST_CASE("curved solids are drawn correctly with depths of 4 bits and of 30 bits") {
  const std::string csg =
      unite({subtract({ball({0, 0, 0}, 6), rod({0, 0, -8}, 16, 2)}), cylinder({6, 4, -6}, 9, 4, 0)});
  for (const unsigned bits : {4U, 6U, 12U, 26U, 30U}) {
    CAPTURE(bits);
    CurvedLook how = lenient;
    how.z_bits = bits;
    how.shares = 2;
    look_both_ways(csg, {20, -30, 10}, {0, 0, 0}, how);
    how.fraction_bits = bits < 20 ? 20 : 4;
    how.share = 1;
    look_both_ways(csg, {20, -30, 10}, {0, 0, 0}, how);
  }
}
