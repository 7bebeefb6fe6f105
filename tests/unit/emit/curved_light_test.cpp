#include "tests/support/test.h"
#include "tests/unit/emit/lambert.h"

using namespace csgsim;
using namespace testing;

namespace {

const std::vector<scene::Light> usual{light({0.36, -0.56, 0.75}, {1, 1, 1}, 0.7)};
const std::vector<scene::Light> two{light({0.36, -0.56, 0.75}, {1, 1, 1}, 0.7),
                                    light({-0.6, 0.2, 0.4}, {1, 0.4, 0}, 0.5)};
const std::vector<scene::Light> three{light({0.36, -0.56, 0.75}, {1, 1, 1}, 0.5),
                                      light({-0.6, 0.2, 0.4}, {1, 0.4, 0}, 0.5),
                                      light({0, 0.9, -0.1}, {0.1, 0.3, 1}, 0.8)};

const Solid ball{{0.3, -0.2, 0.1}, glm::dmat3(1), 6};
const Solid rod{{0.3, -0.2, 0.1}, {{0.6, 0, -0.8}, {0, 1, 0}, {0.8, 0, 0.6}}, 3, 9};

}  // namespace

TEST_CASE("spheres and cylinders under one to three lights follow Lambert's law") {
  Errors errors;
  for (const Solid& solid : {ball, rod})
    for (const auto& colour : std::array<std::optional<glm::dvec3>, 5>{
             std::nullopt, glm::dvec3(0), glm::dvec3(1), glm::dvec3(1, 0, 0.4), glm::dvec3(0.2, 0.6, 0.01)})
      for (const auto& lights : {usual, two, three})
        for (const unsigned colour_bits : {24U, 18U, 12U, 8U}) {
          Errors here;
          measure({solid, colour, lights, 0.3, {0, -12, 30}, colour_bits}, here);
          CAPTURE(colour_bits);
          CAPTURE(lights.size());
          CAPTURE(solid.height);
          CHECK(here.part <= 1);
          errors.levels = std::max(errors.levels, here.levels);
          errors.part = std::max(errors.part, here.part);
          errors.checked += here.checked;
          errors.lit += here.lit;
        }
  MESSAGE(errors.checked, " pixels, ", errors.levels, " levels off at most, ", errors.part, " of the tolerance");
  CHECK(errors.checked > 80'000);
  CHECK(errors.lit > 60'000);
}

TEST_CASE("light of curved solids that exceeds a channel saturates it") {
  Errors errors;
  for (const double intensity : {1.0, 6.5, 7.5, 10.0})
    for (const unsigned colour_bits : {24U, 15U, 3U})
      for (const unsigned z_bits : {20U, 8U, 4U}) {
        Errors here;
        std::vector<scene::Light> lights = two;
        for (scene::Light& one : lights) one.intensity = intensity;
        measure({ball, glm::dvec3(1, 0.9, 0.2), lights, 0.3, {0, -12, 30}, colour_bits, z_bits}, here);
        CAPTURE(intensity);
        CAPTURE(colour_bits);
        CAPTURE(z_bits);
        CAPTURE(here.levels);
        CHECK(here.part <= 1);
        errors.checked += here.checked;
      }
  CHECK(errors.checked > 20'000);
}

TEST_CASE("coarse depth does not bias the brightness of curved solids") {
  for (const unsigned z_bits : {4U, 5U, 6U, 8U})
    for (const auto& shines : {glm::dvec3(0.3, -0.4, 0.85), glm::dvec3(0.8, 0, 0.6), glm::dvec3(-0.8, 0.1, -0.6)}) {
      Errors errors;
      measure({ball, glm::dvec3(1), {light(shines, {1, 1, 1}, 0.6)}, 0.2, {0, -12, 30}, 24, z_bits}, errors);
      const double step = 255 * 0.6 * std::abs(shines.z) * 12 / (6 * (std::exp2(z_bits) - 4));
      CAPTURE(z_bits);
      CAPTURE(shines.z);
      CAPTURE(step);
      CHECK(errors.summed > 300);
      CHECK(std::abs(errors.sum / errors.summed) < 0.5 + step / 5);
    }
}

TEST_CASE("negligible depth terms of a bright light are replaced by their middle value") {
  // A small cube far in front leaves the sphere only the last part of the depths.
  for (const double forward : {0.0005, -0.0005}) {
    Case one{{{0, 0, 0}, glm::dmat3(1), 3}, glm::dvec3(1), {light({1, 0, forward}, {1, 1, 1}, 5.4)}, 0.1};
    one.beside = "multmatrix([[1,0,0,7],[0,1,0,7],[0,0,1,30],[0,0,0,1]]){cube(size=[0.1,0.1,0.1],center=false);}";
    Errors errors;
    measure(one, errors);
    CAPTURE(forward);
    CHECK(errors.checked > 200);
    CHECK(errors.part <= 1);
    CHECK(errors.levels < 5);
  }
}
