#include "tests/oracle/random_curves.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "tests/oracle/split_mix.h"

namespace csgsim::testing {

namespace {

// Each number is drawn in a separate statement: compilers differ in the order in which they evaluate a call's
// arguments.

glm::dvec3 on_grid(Random& random, int most) {
  glm::dvec3 place(0);
  for (int i = 0; i < 3; ++i) {
    const auto steps = static_cast<double>(random.below(static_cast<std::uint64_t>(4 * most) + 1));
    place[i] = 0.5 * steps - most;
  }
  return place;
}

/// The images of the axes under a random rotation by right angles, as columns.
std::array<glm::dvec3, 3> right_angled(Random& random) {
  std::array<glm::dvec3, 3> axes{glm::dvec3(1, 0, 0), {0, 1, 0}, {0, 0, 1}};
  const std::uint64_t first = random.below(3);
  std::swap(axes[0], axes.at(first));
  if (random.below(2) == 0) std::swap(axes[1], axes[2]);
  for (glm::dvec3& axis : axes) axis *= random.one_of({1.0, 1.0, -1.0});
  return axes;
}

std::array<glm::dvec3, 3> turned(Random& random) {
  const double a = 6.283185307179586 * random.unit();
  const double b = 6.283185307179586 * random.unit();
  const double sa = std::sin(a);
  const double ca = std::cos(a);
  const double sb = std::sin(b);
  const double cb = std::cos(b);
  return {glm::dvec3(ca, sa, 0), {-sa * cb, ca * cb, sb}, {sa * sb, -ca * sb, cb}};
}

std::string placed(Random& random, const std::string& what) {
  std::array<glm::dvec3, 3> axes = random.below(5) == 0 ? turned(random) : right_angled(random);
  if (random.below(4) == 0) {
    for (glm::dvec3& axis : axes) axis *= random.one_of({0.5, 1.0, 2.0});
  }
  if (random.below(6) == 0) axes[0] += axes[1] * random.one_of({0.5, -0.5, 1.0});
  if (random.below(6) == 0) axes[2] += axes[0] * random.one_of({0.5, -0.5, 1.0});
  const glm::dvec3 at = on_grid(random, 3);
  return fmt::format("multmatrix([[{},{},{},{}],[{},{},{},{}],[{},{},{},{}],[0,0,0,1]]){{{}}}\n", axes[0].x, axes[1].x,
                     axes[2].x, at.x, axes[0].y, axes[1].y, axes[2].y, at.y, axes[0].z, axes[1].z, axes[2].z, at.z,
                     what);
}

std::string cylinder(Random& random, bool is_cone) {
  const double low = random.one_of({0.5, 1.0, 1.5, 2.0, 3.0, 4.0});
  const double high = is_cone ? random.one_of({0.0, 0.0, 0.5, 1.0, 2.0, 3.0}) : low;
  const double height = random.one_of({0.5, 1.0, 2.0, 3.0, 4.0, 6.0});
  const unsigned fragments = random.below(10) == 0 ? 5 : 32;
  const bool is_centred = random.below(2) == 0;
  return fmt::format("cylinder($fn={},$fa=12,$fs=2,h={},r1={},r2={},center={});", fragments, height, low, high,
                     is_centred);
}

std::string solid(Random& random) {
  const std::uint64_t kind = random.below(8);
  if (kind < 3) {
    const double radius = random.one_of({0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0});
    return placed(random, fmt::format("sphere($fn=32,$fa=12,$fs=2,r={});", radius));
  }
  if (kind < 7) return placed(random, cylinder(random, kind > 4));
  const glm::dvec3 size = on_grid(random, 2) + glm::dvec3(2.5);
  return placed(random, fmt::format("cube(size=[{},{},{}],center=true);", size.x, size.y, size.z));
}

std::string tree(Random& random, unsigned primitives) {
  if (primitives == 1) return solid(random);
  std::string text = fmt::format("{}(){{\n", random.one_of({"union", "difference", "intersection", "difference"}));
  unsigned left = primitives;
  while (left > 0) {
    const unsigned most = left == primitives ? primitives - 1 : left;
    const unsigned next = 1 + static_cast<unsigned>(random.below(most));
    const std::string part = tree(random, next);
    // Repeats the part, so that surfaces coincide everywhere.
    text += part;
    if (random.below(12) == 0) text += part;
    left -= next;
  }
  return text + "}\n";
}

view::Camera camera_of(Random& random, view::Projection projection) {
  const std::uint64_t kind = random.below(4);
  glm::dvec3 direction = on_grid(random, 3);
  if (kind == 0) direction = right_angled(random)[0];
  if (kind == 1) direction = turned(random)[0];
  if (direction == glm::dvec3(0)) direction = {0, -1, 0};
  const glm::dvec3 centre = random.below(2) == 0 ? glm::dvec3(0) : on_grid(random, 2);
  double distance = random.one_of({24.0, 32.0, 48.0});
  if (projection == view::Projection::perspective) distance = random.one_of({0.5, 2.0, 4.0, 8.0, 16.0, 32.0});
  return {centre + distance * glm::normalize(direction), centre, projection};
}

}  // namespace

CurvedScene random_curves(std::uint64_t seed, view::Projection projection) {
  Random random(seed);
  CurvedScene scene;
  scene.camera = camera_of(random, projection);
  scene.sampling.width = random.one_of({15U, 16U, 21U, 24U});
  scene.sampling.height = random.one_of({11U, 15U, 16U, 20U});
  scene.sampling.z_bits = random.one_of({4U, 5U, 6U, 7U, 8U, 10U});
  scene.sampling.fraction_bits = random.one_of({2U, 4U, 8U, 12U, 12U, 16U});
  if (projection == view::Projection::perspective && random.below(2) == 0) {
    scene.sampling.near = random.one_of({0.25, 0.5, 1.0, 2.0});
  }
  const auto primitives = 1 + static_cast<unsigned>(random.below(7));
  scene.csg = tree(random, primitives);
  return scene;
}

}  // namespace csgsim::testing
