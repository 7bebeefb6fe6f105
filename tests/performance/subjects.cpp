#include "tests/performance/subjects.h"

#include <fmt/format.h>

#include <cmath>
#include <random>

namespace csgsim::bench {

namespace {

std::string moved(double x, double y, double z, const std::string& solid) {
  return fmt::format("multmatrix([[1, 0, 0, {:.6g}], [0, 1, 0, {:.6g}], [0, 0, 1, {:.6g}], [0, 0, 0, 1]]) {{ {} }}\n",
                     x, y, z, solid);
}

}  // namespace

std::string grid_of_cubes(unsigned cubes) {
  const auto side = static_cast<unsigned>(std::ceil(std::sqrt(cubes)));
  std::string text;
  for (unsigned i = 0; i < cubes; ++i) {
    text += fmt::format(
        "multmatrix([[1, 0, 0, {}], [0, 1, 0, {}], [0, 0, 1, 0], [0, 0, 0, 1]]) {{ cube(size = [6, 6, {}], center = "
        "true); }}\n",
        10 * static_cast<int>(i % side) - 5 * static_cast<int>(side - 1),
        10 * static_cast<int>(i / side) - 5 * static_cast<int>(side - 1), 4 + i % 7);
  }
  return text;
}

std::string drilled_sphere(unsigned fragments) {
  constexpr const char* cylinder = "cylinder($fn = 16, $fa = 12, $fs = 2, h = 120, r1 = 12, r2 = 12, center = true);";
  return fmt::format(
      "difference() {{\n  sphere($fn = {}, $fa = 12, $fs = 2, r = 50);\n  {}\n"
      "  multmatrix([[1, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]]) {{ {} }}\n"
      "  multmatrix([[0, 0, 1, 0], [0, 1, 0, 0], [-1, 0, 0, 0], [0, 0, 0, 1]]) {{ {} }}\n}}\n",
      fragments, cylinder, cylinder, cylinder);
}

std::string deep_tree(unsigned boxes) {
  // The density of boxes does not depend on their number.
  const double side = 2 * std::cbrt(static_cast<double>(boxes));
  std::mt19937_64 random(1987);
  std::uniform_real_distribution<double> place(-side / 2, side / 2);
  const auto box = [&](int depth) {
    const double x = place(random);
    const double y = place(random);
    return moved(x, y, place(random), fmt::format("cube(size = [2, {}, 2], center = true);", depth));
  };
  std::string text;
  for (unsigned i = 1; i < boxes; ++i) text += i % 3 == 0 ? "difference() {\n" : "union() {\n";
  text += box(2);
  for (unsigned i = 1; i < boxes; ++i) text += box(1) + "}\n";
  return text;
}

std::string drilled_plate(unsigned holes, unsigned facets, double radius) {
  const auto side = static_cast<unsigned>(std::ceil(std::sqrt(holes)));
  const double middle = static_cast<double>(side) - 1;
  std::string text = fmt::format("difference() {{\n  cube(size = [{0}, {0}, 1], center = true);\n", 2 * side);
  const std::string cylinder = fmt::format(
      "cylinder($fn = {}, $fa = 12, $fs = 2, h = 3, r1 = {:g}, r2 = {:g}, center = true);", facets, radius, radius);
  for (unsigned i = 0; i < holes; ++i) {
    text += "  " + moved(2.0 * static_cast<double>(i % side) - middle, 2.0 * static_cast<double>(i / side) - middle, 0,
                         cylinder);
  }
  return text + "}\n";
}

unsigned sphere_halfspaces(unsigned fragments) { return fragments * ((fragments + 1) / 2 - 1) + 2; }

}  // namespace csgsim::bench
