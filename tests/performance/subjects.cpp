#include "tests/performance/subjects.h"

#include <fmt/format.h>

#include <cmath>

namespace csgsim::bench {

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

unsigned sphere_halfspaces(unsigned fragments) { return fragments * ((fragments + 1) / 2 - 1) + 2; }

}  // namespace csgsim::bench
