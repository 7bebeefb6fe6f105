#include "host/emit/compile.h"
#include "host/emit/options.h"
#include "host/facet/geometry.h"
#include "host/read/read.h"
#include "host/view/projection.h"
#include "hw/division/division_check.h"
#include "hw/division/model_sizes.h"
#include "hw/isa/binary.h"
#include "hw/isa/facts.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/text.h"
#include "hw/kinds/load.h"
#include "hw/machines/runs_on.h"
#include "hw/pixel_square/figures.h"
#include "tests/support/test.h"
#include "tests/support/two_cubes.h"

using namespace csgsim;
using testing::error_of;

namespace {

/// Two cubes in the middle of a picture of 3 x 2 groups of 2 x 2 squares; some squares are empty.
isa::Program divided(const machines::Machine& machine, const emit::Options& options = {}) {
  return testing::two_cubes(machine, {0, 0, 0}, options);
}

machines::Machine machine_with(std::uint32_t levels) {
  machines::Machine machine = kinds::load("pixel-square");
  machines::set_picture_size(machine, {96, 64});
  auto& figures = machines::kind_figures<pixel_square::Figures>(machine);
  figures.levels = levels;
  figures.group_side = 2;
  return machine;
}

}  // namespace

TEST_CASE("a Program for a dividing machine contains the model and its division") {
  for (const std::uint32_t levels : {1U, 2U}) {
    const machines::Machine machine = machine_with(levels);
    const isa::Program program = divided(machine);
    CHECK_NOTHROW(machines::check_runs_on(program, machine));
    CHECK_NOTHROW(division::check_division(program));
    // Two primitives have two boxes, for each of 24 squares or 6 groups.
    std::uint64_t boxes = 0;
    std::uint64_t group_boxes = 0;
    for (const isa::Segment& segment : program.segments) {
      boxes += segment.division->sum().boxes;
      group_boxes += segment.division->group_boxes;
    }
    CHECK(group_boxes == (levels == 1 ? 0 : 2 * 6));
    CHECK((levels == 1 ? boxes == 2 * 24 : boxes < 2 * 24));
  }
}

TEST_CASE("the display model survives the binary and the text form of a Program") {
  const isa::Program program = divided(machine_with(2));
  CHECK(isa::decode(isa::encode(program), "binary") == program);
  std::ostringstream text;
  isa::print(text, program);
  CHECK(isa::parse(text.str(), "text") == program);
}

TEST_CASE("a Program whose instructions do not match its display model is rejected") {
  const machines::Machine machine = machine_with(2);
  isa::Program program = divided(machine);
  for (isa::Segment& segment : program.segments) {
    if (!segment.instructions.empty()) segment.instructions.pop_back();
  }
  CHECK(error_of([&] { division::check_division(program); }).find("does not match the division of its display model") !=
        std::string::npos);
}

TEST_CASE("a display model that is missing or exceeds the divider's memory is rejected") {
  machines::Machine machine = machine_with(2);
  isa::Program program = divided(machine);
  auto& figures = machines::kind_figures<pixel_square::Figures>(machine);
  const division::ModelSizes sizes = division::read_model_sizes(program.display_model);
  const std::uint64_t rest =
      8 * program.display_model.size() - sizes.planes * (1 + 2 * std::uint64_t{sizes.slope} + sizes.constant);
  figures.model_bits = static_cast<std::uint32_t>(rest);
  CHECK_NOTHROW(machines::check_runs_on(program, machine));
  figures.model_bits = static_cast<std::uint32_t>(rest - 1);
  CHECK(error_of([&] { machines::check_runs_on(program, machine); })
            .starts_with(fmt::format("the display model has {} bits without its planes, but the divider's memory holds "
                                     "{}; increase divider.memory,",
                                     rest, rest - 1)));
  machine = machine_with(2);
  program.display_model.clear();
  CHECK(error_of([&] {
          machines::check_runs_on(program, machine);
        }).starts_with("the Program has no display model for pixel-square to divide;"));
}

TEST_CASE("small memories of a divider spill to the model memory until that is full") {
  machines::Machine machine = machine_with(2);
  const isa::Program program = divided(machine);
  auto& figures = machines::kind_figures<pixel_square::Figures>(machine);
  figures.store_words = 1;
  CHECK_NOTHROW(machines::check_runs_on(program, machine));
  for (std::uint32_t* const at_hand : {&figures.halfspaces, &figures.nodes}) {
    const std::uint32_t there = std::exchange(*at_hand, 1);
    CHECK_NOTHROW(machines::check_runs_on(program, machine));
    const auto memory = std::exchange(figures.model_bits, static_cast<std::uint32_t>(8 * program.display_model.size()));
    CHECK(error_of([&] {
            machines::check_runs_on(program, machine);
          }).find("these exceed divider.halfspaces, divider.nodes and divider.memory; increase them,") !=
          std::string::npos);
    figures.model_bits = memory;
    *at_hand = there;
  }
}

TEST_CASE("a machine that divides the model rejects prunings other than its divider's") {
  emit::Options options;
  options.pruning = csg::Pruning::divider();
  CHECK_NOTHROW(divided(machine_with(1), options));
  options.pruning.sets = false;
  CHECK(error_of([&] {
          divided(machine_with(1), options);
        }).starts_with("the machine divides the model itself, with fixed prunings;"));
}

TEST_CASE("strategies other than the stack are rejected on a machine that divides the model") {
  emit::Options options;
  options.strategy = emit::Strategy::list;
  CHECK(
      error_of([&] {
        divided(machine_with(1), options);
      }).starts_with("the machine divides the model itself, and its divider supports only --strategy stack, not list"));
  options.strategy = emit::Strategy::automatic;
  options.colouring = emit::Colouring::automatic;
  CHECK(divided(machine_with(1), options).facts->compile.strategy == "stack");
}
