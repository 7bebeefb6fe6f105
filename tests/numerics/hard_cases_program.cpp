#include <hwy/targets.h>

#include "tests/numerics/hard_case.h"
#include "tests/numerics/solids.h"
#include "tests/support/test.h"

using namespace csgsim::testing;

namespace {

std::string hard_model() {
  const std::string cylinders = unite({cylinder({0, 0, 0}, 5, 4, 4, 15), cylinder({0, 0, 5}, 5, 4, 4, 15)});
  return with_transform(rotation(23, 57), subtract({unite({cylinders, box({0, -6, 0}, {9, 6, 5})}),
                                                    box({2, -6, 0}, {7, 0, 10}), ball({0, 0, 10}, 3, 24)}));
}

Compiled compiled(Projection projection) {
  Look how;
  how.sampling.width = 201;
  how.sampling.height = 153;
  return compile_text(hard_model(),
                      {whole(hard_model(), {0.61, -0.74, 0.52}, projection), how.sampling, how.memory_bits});
}

void use_instruction_set(std::int64_t target) {
  hwy::SetSupportedTargetsForTest(target);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace

TEST_CASE("a Program gives the same bits with every instruction set of this processor") {
  for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
    const csgsim::isa::Program program = compiled(projection).program;
    const csgsim::observe::Frame best = draw(program);
    CHECK(covered_pixels(best, 20) > 1000);
    for (std::int64_t left = hwy::SupportedTargets(); left != 0; left &= left - 1) {
      use_instruction_set(left & -left);
      const csgsim::observe::Frame frame = draw(program);
      use_instruction_set(0);
      CHECK(frame.depth == best.depth);
      CHECK(frame.owner == best.owner);
      CHECK(frame.colour == best.colour);
    }
  }
}
TEST_CASE("a Program gives the same bits on one thread and on several") {
  for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
    const csgsim::isa::Program program = compiled(projection).program;
    const csgsim::observe::Frame one = draw(program);
    for (const unsigned threads : {2U, 3U, 16U}) {
      const csgsim::observe::Frame several = draw(program, threads);
      CHECK(several.depth == one.depth);
      CHECK(several.owner == one.owner);
      CHECK(several.colour == one.colour);
    }
  }
}
TEST_CASE("the same model compiles to the same Program every time") {
  for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
    CHECK(compiled(projection).program == compiled(projection).program);
  }
}
TEST_CASE("all engines agree in every bit on the hardest of the models") {
  const Verdict verdict = look_around(hard_model());
  CHECK(verdict.pictures == 16);
  CHECK(verdict.covered > 10000);
}
