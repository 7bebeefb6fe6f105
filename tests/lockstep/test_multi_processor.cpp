// SystemC elaborates once per process, so ctest runs each case here in a separate process.

#include "host/emit/compile.h"
#include "host/facet/geometry.h"
#include "host/read/read.h"
#include "host/view/projection.h"
#include "hw/division/divide.h"
#include "hw/division/division_check.h"
#include "hw/division/encoding.h"
#include "hw/isa/facts.h"
#include "hw/isa/host_counts.h"
#include "hw/kinds/load.h"
#include "hw/multi_processor/figures.h"
#include "sim/engine/engine.h"
#include "tests/support/test.h"
#include "tests/support/two_cubes.h"
#include "tests/unit/division/hand_models.h"

using namespace csgsim;

namespace {

machines::Machine machine_32x32() {
  machines::Machine machine = kinds::load("multi-processor");
  machines::set_picture_size(machine, {32, 32});
  return machine;
}

/// A cube with a notch in the middle of the picture.
isa::Program program_for(const machines::Machine& machine) { return testing::two_cubes(machine, {2, 2, 2}); }

std::vector<std::uint8_t> bytes_of(const division::DisplayModel& model) {
  const division::Bits bits = division::encode(model);
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>((bits.count + 7) / 8));
  for (std::size_t i = 0; i < bytes.size(); ++i)
    bytes[i] = static_cast<std::uint8_t>(bits.words[i / 8] >> (i % 8 * 8) & 0xffU);
  return bytes;
}

}  // namespace

TEST_CASE("a multi-processor draws a display model in which a facet was recoloured") {
  const machines::Machine machine = machine_32x32();
  const auto engine = engine::make_cycle_engine(machine);
  isa::Program program = program_for(machine);
  const std::vector<std::uint32_t> before = engine->run(program, {}).scanned_out;
  division::DisplayModel model = division::display_model_of(program.display_model);
  std::vector<division::Halfspace>& facets = model.primitives.front().halfspaces;
  const std::uint32_t old = *std::find_if(before.begin(), before.end(), [&](std::uint32_t colour) {
    return std::any_of(facets.begin(), facets.end(), [&](const auto& one) { return one.colour == colour; });
  });
  constexpr std::uint32_t other = 0x123456;
  for (division::Halfspace& facet : facets) {
    if (facet.colour == old) facet.colour = other;
  }
  program.display_model = bytes_of(model);
  CHECK_THROWS_AS(engine->run(program, {}), InputError);
  testing::ModelDivider divider(model);
  for (isa::Segment& segment : program.segments) segment.instructions = divider.divide(segment.region).instructions;
  const std::vector<std::uint32_t> after = engine->run(program, {}).scanned_out;
  REQUIRE(after.size() == before.size());
  CHECK(std::count(after.begin(), after.end(), other) > 0);
  for (std::size_t i = 0; i < after.size(); ++i)
    CHECK((after[i] == before[i] || (before[i] == old && after[i] == other)));
}

TEST_CASE("a display model with a flipped bit is rejected or gives the same picture") {
  const machines::Machine machine = machine_32x32();
  const auto engine = engine::make_cycle_engine(machine);
  const isa::Program program = program_for(machine);
  std::size_t refused = 0;
  std::size_t tried = 0;
  // Bits on which no list depends leave the picture unchanged.
  const std::vector<std::uint32_t> picture = engine->run(program, {}).scanned_out;
  for (std::size_t bit = 0; bit < 8 * program.display_model.size(); bit += 37, ++tried) {
    isa::Program changed = program;
    changed.display_model[bit / 8] = static_cast<std::uint8_t>(changed.display_model[bit / 8] ^ 1U << bit % 8);
    try {
      const std::vector<std::uint32_t> drawn = engine->run(changed, {}).scanned_out;
      CHECK(drawn == picture);
    } catch (const InputError&) {
      ++refused;
    }
  }
  CHECK(2 * refused > tried);
}

TEST_CASE("a multi-processor counts its tests and ignores those stated in a Program") {
  const machines::Machine machine = machine_32x32();
  const auto engine = engine::make_cycle_engine(machine);
  isa::Program program = program_for(machine);
  const engine::RunResult before = engine->run(program, {});
  CHECK(before.clocks == engine::make_functional_engine(machine)->run(program, {}).clocks);
  for (isa::Segment& segment : program.segments) {
    segment.division->steps.push_back({.halfspaces = 3, .nodes = 2});
    segment.division->group_boxes += 1;
  }
  program.facts->model = {};
  const engine::RunResult after = engine->run(program, {});
  CHECK(after.clocks == before.clocks);
  CHECK(after.account == before.account);
  CHECK(engine::make_functional_engine(machine)->run(program, {}).clocks > before.clocks);
}

/// The pictures themselves are tested with random models (tests/lockstep/multi_processor.cpp).
TEST_CASE("a multi-processor's nodes render long lists in the predicted number of passes") {
  machines::Machine machine = machine_32x32();
  const isa::Program program = program_for(machine);
  const engine::RunResult whole = engine::make_functional_engine(machine)->run(program, {});
  CHECK(whole.account.count("list_passes") == whole.account.count("active_segments"));
  machines::kind_figures<multi_processor::Figures>(machine).memory_words = 200;
  const engine::RunResult parts = engine::make_cycle_engine(machine)->run(program, {});
  CHECK(parts.account.count("list_passes") > parts.account.count("active_segments"));
  CHECK(parts.clocks == engine::make_functional_engine(machine)->run(program, {}).clocks);
}
