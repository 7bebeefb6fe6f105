#include <rapidcheck.h>

#include "tests/support/test.h"
#include "tests/unit/emit/lambert.h"

using namespace csgsim;
using namespace testing;

namespace {

double real(double low, double high) {
  return low + (high - low) * *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1'000'001)) / 1e6;
}

glm::dvec3 direction() {
  glm::dvec3 one{0};
  while (glm::length(one) < 0.1) one = {real(-1, 1), real(-1, 1), real(-1, 1)};
  return glm::normalize(one);
}

glm::dmat3 turn() {
  const glm::dvec3 x = direction();
  glm::dvec3 y = direction();
  while (std::abs(glm::dot(x, y)) > 0.9) y = direction();
  y = glm::normalize(y - x * glm::dot(x, y));
  return {x, y, glm::cross(x, y)};
}

Case any_case() {
  Case one;
  one.solid = {{real(-2, 2), real(-2, 2), real(-2, 2)}, turn(), real(1, 7)};
  if (*rc::gen::arbitrary<bool>()) one.solid.height = real(1, 12);
  one.eye = direction() * *rc::gen::element(25.0, 50.0);
  if (*rc::gen::arbitrary<bool>()) one.colour = glm::dvec3(real(0, 1), *rc::gen::element(0.0, real(0, 1)), real(0, 1));
  const int count = *rc::gen::inRange(1, 4);
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 colour(real(0, 1), *rc::gen::element(0.0, 1.0, real(0, 1)), real(0, 1));
    one.lights.push_back(light(direction(), colour, *rc::gen::element(real(0, 1), real(1, 10))));
  }
  one.ambient = real(0, 1);
  one.colour_bits = static_cast<unsigned>(*rc::gen::inRange(3, 25));
  one.z_bits = static_cast<unsigned>(*rc::gen::inRange(4, 25));
  return one;
}

}  // namespace

TEST_CASE("spheres and cylinders in random positions and lights follow Lambert's law") {
  Errors errors;
  CHECK(rc::check([&] {
    const Case one = any_case();
    Errors here;
    measure(one, here);
    errors.checked += here.checked;
    errors.part = std::max(errors.part, here.part);
    RC_LOG() << one.solid.text() << " colour bits " << one.colour_bits << " z bits " << one.z_bits << " lights "
             << one.lights.size() << ": " << here.levels << " levels off, " << here.part << " of the tolerance\n";
    RC_ASSERT(here.part <= 1);
  }));
  MESSAGE(errors.checked, " pixels, ", errors.part, " of the tolerance at most");
  CHECK((!testing::draws_usual_cases() || errors.checked > 20'000));
}
