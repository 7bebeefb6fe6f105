#include "sim/judges/errors.h"

#include "hw/isa/facts.h"
#include "sim/judges/truth.h"
#include "tests/support/test.h"

using namespace csgsim;
using namespace judges;

namespace {

constexpr unsigned z_bits = 12;
constexpr std::uint32_t farthest = (1U << z_bits) - 1;
constexpr std::size_t pixel = 1234;

/// Depth step d represents the distance d - 1.
isa::Program unit_steps() {
  isa::Program program;
  program.facts->compile.z_bits = z_bits;
  program.facts->depth_scale = {false, 0, farthest - 3};
  return program;
}

struct Pictures {
  Truth truth;
  observe::Frame frame;
};

/// 50 x 40 pixels with two primitives and a quarter of background; the picture is correct everywhere.
Pictures identical() {
  Pictures p{judges::empty_truth(50, 40), {}};
  p.frame = {
      50, 40, {}, std::vector<std::uint32_t>(2000, farthest), std::vector<std::uint32_t>(2000, observe::no_owner)};
  for (std::uint32_t i = 500; i < 2000; ++i) {
    p.truth.owner[i] = p.frame.owner[i] = i % 2;
    p.truth.distance[i] = i;
    p.frame.depth[i] = i + 1;
  }
  return p;
}

Errors errors_of(const Pictures& p) { return compare(p.truth, p.frame, unit_steps()); }

void check_no_depth_error(const Errors& errors) {
  CHECK(errors.steps.max == 0);
  CHECK(errors.model_units.max == 0);
}

}  // namespace

TEST_CASE("comparing identical pictures finds no differences") {
  const Errors errors = errors_of(identical());
  CHECK(errors.pixels == 2000);
  CHECK(errors.covered == 1500);
  CHECK(errors.wrong() == 0);
  CHECK(errors.unexplained == 0);
  check_no_depth_error(errors);
}

TEST_CASE("a surface in only one picture counts as a silhouette error without depth error") {
  Pictures p = identical();
  p.frame.depth[pixel] = farthest;
  p.frame.depth[7] = 9;
  p.frame.owner[7] = 0;
  const Errors errors = errors_of(p);
  CHECK(errors.silhouette == 2);
  CHECK(errors.wrong() == 2);
  CHECK(errors.covered == 1500);
  check_no_depth_error(errors);
}

TEST_CASE("comparing pictures ignores the owner of a background pixel") {
  Pictures p = identical();
  p.frame.owner[7] = 1;
  CHECK(errors_of(p).wrong() == 0);
}

TEST_CASE("a different owner counts as an owner error for any depth") {
  Pictures p = identical();
  p.frame.owner[pixel] ^= 1U;
  p.frame.depth[pixel] += 500;
  const Errors errors = errors_of(p);
  CHECK(errors.owner == 1);
  CHECK(errors.wrong() == 1);
  check_no_depth_error(errors);
}

TEST_CASE("a depth error is measured in steps and in model units") {
  Pictures p = identical();
  p.frame.depth[pixel] -= 3;
  isa::Program coarse = unit_steps();
  CHECK(errors_of(p).wrong() == 0);
  CHECK(errors_of(p).steps.max == 3);
  CHECK(errors_of(p).model_units.max == 3);
  coarse.facts->depth_scale.far *= 4;
  for (double& distance : p.truth.distance) distance *= 4;
  CHECK(compare(p.truth, p.frame, coarse).steps.max == 3);
  CHECK(compare(p.truth, p.frame, coarse).model_units.max == 12);
}

TEST_CASE("in perspective the length of a depth step follows the depth scale") {
  Pictures p = identical();
  isa::Program program = unit_steps();
  program.facts->depth_scale = {true, 10, 40};
  for (std::size_t i = 0; i < p.truth.owner.size(); ++i) {
    // Depth 1 is at 10 and farthest - 2 at 40, linear in the reciprocal of the distance.
    const double part = (p.frame.depth[i] - 1.0) / (farthest - 3.0);
    if (p.truth.owner[i] != nothing) p.truth.distance[i] = 1 / (0.1 - part * 0.075);
  }
  CHECK(compare(p.truth, p.frame, program).model_units.max < 1e-12);
  CHECK(compare(p.truth, p.frame, program).steps.max < 1e-9);
  ++p.frame.depth[1999];
  // dz/dt is the number of steps over 0.075 t^2.
  const double distance = p.truth.distance[1999];
  const double step = 0.075 * distance * distance / (farthest - 3.0);
  CHECK(compare(p.truth, p.frame, program).steps.max == doctest::Approx(1));
  CHECK(compare(p.truth, p.frame, program).model_units.max == doctest::Approx(step).epsilon(1e-3));
}

TEST_CASE("p999 is the error bound of 99.9 % of the pixels") {
  Pictures p = identical();
  // 1000 pixels with the right owner have errors of 1/1024, 2/1024 and so on; the pixels with the largest errors have
  // the wrong owner.
  for (std::size_t i = 500; i < 1500; ++i) p.truth.distance[i] += static_cast<double>((i * 7) % 1000 + 1) / 1024;
  for (std::size_t i = 1500; i < 2000; ++i) {
    p.truth.distance[i] += 77;
    p.frame.owner[i] ^= 1U;
  }
  const Errors errors = errors_of(p);
  CHECK(errors.owner == 500);
  CHECK(errors.steps.max == doctest::Approx(1000.0 / 1024).epsilon(1e-12));
  CHECK(errors.steps.p999 == doctest::Approx(999.0 / 1024).epsilon(1e-12));
  CHECK(errors.model_units.p999 == doctest::Approx(999.0 / 1024).epsilon(1e-12));
}

TEST_CASE("p999 of fewer than a thousand pixels is the maximum error") {
  Pictures p = identical();
  for (std::size_t i = 1000; i < 2000; ++i) {
    p.truth.owner[i] = nothing;
    p.frame.depth[i] = farthest;
  }
  p.frame.depth[700] += 5;
  CHECK(errors_of(p).steps.p999 == 5);
}

TEST_CASE("comparing pictures of different sizes is an error") {
  Pictures p = identical();
  std::swap(p.frame.width, p.frame.height);
  CHECK_THROWS_AS(errors_of(p), std::invalid_argument);
}
