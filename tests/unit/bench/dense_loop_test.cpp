#include "tests/performance/dense_loop.h"

#include <rapidcheck.h>

#include "hw/kinds/load.h"
#include "sim/reference/reference_run.h"
#include "tests/support/random_program.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

/// Compares memory and enable of every pixel of the last segment.
void same_as_reference(const bench::DenseLoop& dense, const reference::ReferenceRun& reference,
                       std::uint16_t memory_bits) {
  const isa::Region region = reference.region();
  for (std::uint32_t y = 0; y < region.height; ++y) {
    for (std::uint32_t x = 0; x < region.width; ++x) {
      RC_ASSERT(dense.enabled(x, y) == reference.is_enabled(x, y));
      for (std::uint16_t bit = 0; bit < memory_bits; ++bit)
        RC_ASSERT(dense.memory_bit(bit, x, y) == (reference.value({bit, 1}, x, y) != 0));
    }
  }
}

}  // namespace

TEST_CASE("the dense loop matches the reference on random Programs") {
  CHECK(rc::check([] {
    const isa::ArrayShape shape{*rc::gen::inRange(1U, 100U), *rc::gen::inRange(1U, 9U), 40};
    const isa::Program program = *test::arbitrary_program(shape, 40, 2);
    machines::Machine machine = kinds::load("pixel-powers");
    machines::adopt_shape(machine, program);
    reference::ReferenceRun reference(program, machine);
    reference.advance(~std::uint64_t{0}, {});
    bench::DenseLoop dense(shape);
    for (const isa::Segment& segment : program.segments) dense.run(segment);
    same_as_reference(dense, reference, static_cast<std::uint16_t>(shape.memory_bits));
  }));
}
