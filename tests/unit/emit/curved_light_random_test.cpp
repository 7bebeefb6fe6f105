#include <rapidcheck.h>

#include "tests/support/test.h"
#include "tests/unit/emit/lambert.h"

using namespace csgsim;
using namespace testing;

namespace {

double random_real(double low, double high) {
  return low + (high - low) * *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1'000'001)) / 1e6;
}

glm::dvec3 random_direction() {
  glm::dvec3 one{0};
  while (glm::length(one) < 0.1) one = {random_real(-1, 1), random_real(-1, 1), random_real(-1, 1)};
  return glm::normalize(one);
}

glm::dmat3 random_rotation() {
  const glm::dvec3 x = random_direction();
  glm::dvec3 y = random_direction();
  while (std::abs(glm::dot(x, y)) > 0.9) y = random_direction();
  y = glm::normalize(y - x * glm::dot(x, y));
  return {x, y, glm::cross(x, y)};
}

Case random_case() {
  Case one;
  one.solid = {{random_real(-2, 2), random_real(-2, 2), random_real(-2, 2)}, random_rotation(), random_real(1, 7)};
  if (*rc::gen::arbitrary<bool>()) one.solid.height = random_real(1, 12);
  one.eye = random_direction() * *rc::gen::element(25.0, 50.0);
  if (*rc::gen::arbitrary<bool>())
    one.colour = glm::dvec3(random_real(0, 1), *rc::gen::element(0.0, random_real(0, 1)), random_real(0, 1));
  const int count = *rc::gen::inRange(1, 4);
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 colour(random_real(0, 1), *rc::gen::element(0.0, 1.0, random_real(0, 1)), random_real(0, 1));
    one.lights.push_back(light(random_direction(), colour, *rc::gen::element(random_real(0, 1), random_real(1, 10))));
  }
  one.ambient = random_real(0, 1);
  one.colour_bits = static_cast<unsigned>(*rc::gen::inRange(3, 25));
  one.z_bits = static_cast<unsigned>(*rc::gen::inRange(4, 25));
  return one;
}

}  // namespace

TEST_CASE("spheres and cylinders in random positions and lights follow Lambert's law") {
  Errors errors;
  CHECK(rc::check([&] {
    const Case one = random_case();
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
