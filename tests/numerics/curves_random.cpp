#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "hw/base/error.h"
#include "tests/numerics/curved_case.h"
#include "tests/numerics/variants.h"
#include "tests/oracle/pixel_oracle.h"
#include "tests/oracle/random_curves.h"

using namespace csgsim;
using testing::CurvedScene;
using testing::Setup;

namespace {

struct Tally {
  std::uint64_t scenes = 0;
  std::uint64_t refused = 0;  ///< nothing to see, or a camera or face that fits no numbers
  std::uint64_t covered = 0;
  std::uint64_t wrong = 0;
  std::uint64_t quadrics = 0;
  std::uint64_t edges = 0;
  std::uint64_t inside = 0;
};

/// A few of all that must not change a picture, others each time.
std::vector<Setup> some_variants(const Setup& how, std::uint64_t seed) {
  static const std::vector<emit::Options> options = testing::all_options();
  std::vector<Setup> all;
  for (std::uint64_t i = 0; i < 3; ++i) {
    Setup other = how;
    other.options = options[(seed + i * 17) % options.size()];
    all.push_back(other);
  }
  std::vector<Setup> machines = testing::in_parts(how);
  for (const Setup& machine : testing::on_quadratic_machines(how)) machines.push_back(machine);
  all.push_back(machines[seed % machines.size()]);
  return all;
}

std::optional<testing::Compiled> compiled(const CurvedScene& scene, const Setup& how) {
  try {
    return testing::compile_text(scene.csg, how);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

void check_scene(std::uint64_t seed, view::Projection projection, Tally& tally) {
  const CurvedScene scene = testing::random_curves(seed, projection);
  Setup how = testing::curved_setup(scene.camera);
  how.sampling = scene.sampling;
  const auto first = compiled(scene, how);
  ++tally.scenes;
  tally.refused += first ? 0U : 1U;
  if (!first) return;
  const sim::Frame frame = testing::draw(first->program);
  const testing::CurvedVerdict verdict = testing::judged(*first, frame);
  RC_ASSERT(verdict.unexplained == 0U);
  RC_ASSERT(verdict.against_rules == 0U);
  for (const Setup& other : some_variants(how, seed)) {
    const sim::Frame again = testing::draw(testing::compile_again(*first, other));
    RC_ASSERT(again.depth == frame.depth);
    RC_ASSERT(again.owner == frame.owner);
    RC_ASSERT(again.colour == frame.colour);
  }
  tally.covered += verdict.covered;
  tally.wrong += verdict.wrong;
  tally.quadrics += verdict.quadrics;
  tally.edges += verdict.edges;
  tally.inside += verdict.inside;
}

void check_scenes(view::Projection projection) {
  Tally tally;
  CHECK(rc::check([&] { check_scene(*rc::gen::arbitrary<std::uint64_t>(), projection, tally); }));
  MESSAGE(tally.scenes, " scenes, ", tally.refused, " refused, ", tally.quadrics, " quadrics, of these ", tally.edges,
          " edges and ", tally.inside, " around the eye, ", tally.covered, " pixels covered, ", tally.wrong, " wrong");
  CHECK(tally.covered > 20 * tally.scenes);
  CHECK(tally.quadrics > tally.scenes / 2);
  CHECK(tally.refused < 1 + tally.scenes / 10);
}

}  // namespace

TEST_CASE("random curved scenes of few bits are the rules' by all ways, and no wrong pixel is unexplained, orthographic") {
  check_scenes(view::Projection::orthographic);
}
TEST_CASE("random curved scenes of few bits are the rules' by all ways, and no wrong pixel is unexplained, perspective") {
  check_scenes(view::Projection::perspective);
}
