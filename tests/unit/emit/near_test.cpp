#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/support/drawing.h"

using namespace csgsim;

namespace {

const std::string cube = "cube(size=10,center=true);";

testing::Setup along_y(double eye, view::Projection projection) {
  testing::Setup made;
  made.camera = {{0, eye, 0}, {0, 0, 0}, projection};
  made.sampling.width = 64;
  made.sampling.height = 48;
  return made;
}

/// Constants that are written to a field, for a purpose.
std::size_t constants_to(const isa::Program& program, const std::string& field, isa::Purpose purpose) {
  const auto named = std::find_if(program.fields.begin(), program.fields.end(),
                                  [&](const isa::NamedField& one) { return one.name == field; });
  REQUIRE(named != program.fields.end());
  const std::vector<isa::Instruction>& all = program.segments.at(0).instructions;
  return static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [&](const isa::Instruction& one) {
    return one.opcode == isa::Opcode::set_constant && one.fields[0] == named->field && one.origin.purpose == purpose;
  }));
}

}  // namespace

TEST_CASE("a solid that begins at the near plane is not capped: its face is at depth 1, and nothing of it at 0") {
  const isa::Program program = testing::compile_text(cube, along_y(-60, view::Projection::orthographic)).program;
  CHECK(constants_to(program, "Z1", isa::Purpose::render) == 0);
  CHECK(constants_to(program, "colour", isa::Purpose::shade) == 1);
}

TEST_CASE("a solid that the near plane cuts is capped at depth 0") {
  testing::Setup how = along_y(-60, view::Projection::perspective);
  how.sampling.near = 58;
  const isa::Program program = testing::compile_text(cube, how).program;
  CHECK(constants_to(program, "Z1", isa::Purpose::render) == 1);
  CHECK(constants_to(program, "colour", isa::Purpose::shade) == 1);
}
