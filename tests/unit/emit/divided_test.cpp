#include <doctest/doctest.h>

#include <sstream>
#include <string>

#include "host/emit/compile.h"
#include "host/emit/options.h"
#include "host/facet/geometry.h"
#include "host/read/read.h"
#include "host/view/projection.h"
#include "hw/base/error.h"
#include "hw/division/division_check.h"
#include "hw/isa/binary.h"
#include "hw/isa/text.h"
#include "hw/kinds/load.h"
#include "hw/machines/runs_on.h"
#include "hw/pixel_square/figures.h"
#include "hw/pixel_square/storage_check.h"
#include "tests/support/error_of.h"
#include "tests/support/two_cubes.h"

using namespace csgsim;

using testing::error_of;

namespace {

/// Two cubes in the middle of a picture of 3 x 2 groups of 2 x 2 squares; nothing in some of them.
isa::Program divided(const machines::Machine& machine, const emit::Options& options = {}) {
  return testing::two_cubes(machine, {0, 0, 0}, options);
}

machines::Machine machine_with(std::uint32_t levels) {
  machines::Machine machine = kinds::load("pixel-square");
  machines::set_picture_size(machine, {96, 64});
  auto& figures = machines::own<pixel_square::Figures>(machine);
  figures.levels = levels;
  figures.group_side = 2;
  return machine;
}

}  // namespace

TEST_CASE("a Program for a machine that divides has the model that is divided into its segments") {
  for (const std::uint32_t levels : {1U, 2U}) {
    const machines::Machine machine = machine_with(levels);
    const isa::Program program = divided(machine);
    CHECK_NOTHROW(machines::check_runs_on(program, machine));
    CHECK_NOTHROW(division::check_division(program));
    // Two primitives have two boxes, for each of 24 squares or 6 groups.
    std::uint64_t boxes = 0;
    std::uint64_t group_boxes = 0;
    for (const isa::Segment& segment : program.segments) {
      boxes += segment.division.sum().boxes;
      group_boxes += segment.division.group_boxes;
    }
    CHECK(group_boxes == (levels == 1 ? 0 : 2 * 6));
    CHECK((levels == 1 ? boxes == 2 * 24 : boxes < 2 * 24));
  }
}

TEST_CASE("the display model survives both forms of a Program") {
  const isa::Program program = divided(machine_with(2));
  CHECK(isa::decode(isa::encode(program), "binary") == program);
  std::ostringstream text;
  isa::print(text, program);
  CHECK(isa::parse(text.str(), "text") == program);
}

TEST_CASE("a Program whose instructions are not those of its model is refused") {
  const machines::Machine machine = machine_with(2);
  isa::Program program = divided(machine);
  for (isa::Segment& segment : program.segments) {
    if (!segment.instructions.empty()) segment.instructions.pop_back();
  }
  CHECK(error_of([&] { division::check_division(program); }).find("is not what its display model") !=
        std::string::npos);
}

TEST_CASE("a machine that divides refuses a Program without a model, and a model that its memory does not hold") {
  machines::Machine machine = machine_with(2);
  isa::Program program = divided(machine);
  machines::own<pixel_square::Figures>(machine).model_bits = 1000;
  const std::string bits = std::to_string(8 * program.display_model.size());
  CHECK(error_of([&] {
          machines::check_runs_on(program, machine);
        }).starts_with("the display model has " + bits + " bits, and the divider's memory holds 1000;"));
  machine = machine_with(2);
  program.display_model.clear();
  CHECK(error_of([&] {
          machines::check_runs_on(program, machine);
        }).starts_with("the Program has no display model, which pixel-square divides;"));
}

TEST_CASE(
    "a machine that divides refuses what its memories for a surface, its tree or a square's commands do not hold") {
  machines::Machine machine = machine_with(2);
  const isa::Program program = divided(machine);
  auto& figures = machines::own<pixel_square::Figures>(machine);
  const auto names = [&](const std::string& figure) {
    for (const std::string& error : {error_of([&] { machines::check_runs_on(program, machine); }),
                                     error_of([&] { pixel_square::check_division(program, machine); })}) {
      CHECK(error.find("; give " + figure + " more, or the model fewer faces") != std::string::npos);
      CHECK(error.find("and the divider keeps 1;") != std::string::npos);
    }
  };
  figures.halfspaces = 1;
  names("divider.halfspaces");
  figures.halfspaces = 4096;
  figures.nodes = 1;
  names("divider.nodes");
  figures.nodes = 1024;
  figures.store_words = 1;
  names("divider.store");
}

TEST_CASE("a machine that divides has prunings of its own") {
  emit::Options options;
  options.pruning = csg::Pruning::divider();
  CHECK_NOTHROW(divided(machine_with(1), options));
  options.pruning.sets = false;
  CHECK(error_of([&] {
          divided(machine_with(1), options);
        }).starts_with("the machine divides the model itself, with prunings of its own;"));
}

TEST_CASE("a machine that divides has one strategy") {
  emit::Options options;
  options.strategy = emit::Strategy::list;
  CHECK(error_of([&] {
          divided(machine_with(1), options);
        }).starts_with("the machine divides the model itself, by the strategy stack alone, not list"));
  options.strategy = emit::Strategy::automatic;
  options.colouring = emit::Colouring::automatic;
  CHECK(divided(machine_with(1), options).facts.compile.strategy == "stack");
}
