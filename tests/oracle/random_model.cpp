#include "tests/oracle/random_model.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "tests/oracle/split_mix.h"

namespace csgsim::testing {

namespace {

/// A random multiple of half a unit from low to high.
double on_grid(Random& random, int low, int high) {
  return low + 0.5 * static_cast<double>(random.below(static_cast<std::uint64_t>(2 * (high - low)) + 1));
}

// Each number is drawn in a separate statement: compilers differ in the order in which they evaluate a call's
// arguments.

std::string place(Random& random) {
  const double z = on_grid(random, -3, 3);
  const double y = on_grid(random, -3, 3);
  const double x = on_grid(random, -3, 3);
  return fmt::format("multmatrix([[1,0,0,{}],[0,1,0,{}],[0,0,1,{}],[0,0,0,1]])", x, y, z);
}

std::string cone(Random& random, bool center) {
  const double top = on_grid(random, 1, 3);
  const double bottom = on_grid(random, 0, 3);
  const double height = on_grid(random, 1, 4);
  const std::uint64_t fragments = 3 + random.below(10);
  return fmt::format("cylinder($fn={},$fa=12,$fs=2,h={},r1={},r2={},center={});", fragments, height, bottom, top,
                     center);
}

std::string sphere(Random& random) {
  const double radius = on_grid(random, 1, 3);
  const std::uint64_t fragments = 4 + random.below(8);
  return fmt::format("sphere($fn={},$fa=12,$fs=2,r={});", fragments, radius);
}

std::string cube(Random& random, bool center) {
  const double z = on_grid(random, 1, 5);
  const double y = on_grid(random, 1, 5);
  const double x = on_grid(random, 1, 5);
  return fmt::format("cube(size=[{},{},{}],center={});", x, y, z, center);
}

std::string solid(Random& random) {
  const std::string where = place(random);
  const bool center = random.below(2) == 0;
  const std::uint64_t kind = random.below(6);
  const std::string what = kind == 0 ? cone(random, center) : kind == 1 ? sphere(random) : cube(random, center);
  return fmt::format("{}{{{}}}\n", where, what);
}

std::string tree(Random& random, unsigned primitives) {
  if (primitives == 1) return solid(random);
  static constexpr const char* operators[] = {"union", "difference", "intersection", "difference"};
  std::string text = fmt::format("{}(){{\n", operators[random.below(4)]);
  const unsigned first = 1 + static_cast<unsigned>(random.below(primitives - 1));
  text += tree(random, first);
  unsigned left = primitives - first;
  while (left > 0) {
    const unsigned next = 1 + static_cast<unsigned>(random.below(left));
    text += tree(random, next);
    left -= next;
  }
  return text + "}\n";
}

std::string rotation(Random& random) {
  if (random.below(4) == 0) return "multmatrix([[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]])";
  const double a = 6.283185307179586 * random.unit();
  const double b = 6.283185307179586 * random.unit();
  const double sa = std::sin(a);
  const double ca = std::cos(a);
  const double sb = std::sin(b);
  const double cb = std::cos(b);
  return fmt::format("multmatrix([[{},{},{},0],[{},{},{},0],[{},{},{},0],[0,0,0,1]])", ca, -sa * cb, sa * sb, sa,
                     ca * cb, -ca * sb, 0.0, sb, cb);
}

}  // namespace

std::string random_model(std::uint64_t seed, unsigned primitives) {
  Random random(seed);
  const std::string outer = rotation(random);
  return outer + "{\n" + tree(random, primitives) + "}\n";
}

}  // namespace csgsim::testing
