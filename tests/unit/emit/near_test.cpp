#include <rapidcheck.h>

#include "host/emit/near_cap.h"
#include "hw/isa/facts.h"
#include "hw/isa/opcodes.h"
#include "hw/pixel_planes/kind.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"

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

/// Constants written to a field for a purpose.
std::vector<std::uint64_t> constants_to(const isa::Program& program, const std::string& field, isa::Purpose purpose) {
  const auto named = std::find_if(program.facts->fields.begin(), program.facts->fields.end(),
                                  [&](const isa::NamedField& one) { return one.name == field; });
  REQUIRE(named != program.facts->fields.end());
  std::vector<std::uint64_t> constants;
  for (const isa::Instruction& one : program.segments.at(0).instructions) {
    if (one.opcode == isa::Opcode::set_constant && one.fields[0] == named->field && one.origin.purpose == purpose)
      constants.push_back(one.constant);
  }
  return constants;
}

}  // namespace

TEST_CASE("a solid that begins at the near plane has its face at depth 1 and no cap") {
  const isa::Program program = testing::compile_text(cube, along_y(-60, view::Projection::orthographic)).program;
  CHECK(constants_to(program, "Z1", isa::Purpose::render).empty());
  CHECK(constants_to(program, "colour", isa::Purpose::shade).size() == 1);
}

TEST_CASE("a solid cut by the near plane gets a cap at depth 0 in frontal colour") {
  testing::Setup how = along_y(-60, view::Projection::perspective);
  how.sampling.near = 58;
  const isa::Program program = testing::compile_text(cube, how).program;
  CHECK(constants_to(program, "Z1", isa::Purpose::render) == std::vector<std::uint64_t>{0});
  const isa::Program straight_on = testing::compile_text(cube, along_y(-60, view::Projection::orthographic)).program;
  CHECK(constants_to(program, "colour", isa::Purpose::shade) ==
        constants_to(straight_on, "colour", isa::Purpose::shade));
}

TEST_CASE("fronts that share a pixel of depth 0 may reach the near plane") {
  const testing::Compiled any = testing::compile_text(cube, along_y(-60, view::Projection::orthographic));
  const emit::Plan plan;
  const emit::SegmentPlan segment;
  const emit::Layout layout;
  const emit::Options options;
  const machines::Machine machine = machines::blank_machine(pixel_planes::kind);
  const emit::Look look;
  CHECK(rc::check([&] {
    view::View view = any.view;
    const view::PixelRect pixels{0, 0, 63, 47};
    const int x = *rc::gen::inRange(0, 64);
    const int y = *rc::gen::inRange(0, 48);
    const std::int64_t step = std::int64_t{1} << view.sampling.fraction_bits;
    view.planes.clear();
    std::vector<emit::Facet> fronts;
    for (std::uint32_t i = *rc::gen::inRange(1U, 4U); i-- > 0;) {
      const unsigned shift = *rc::gen::inRange(0U, 30U);
      view::ScreenPlane plane;
      plane.linear.a = static_cast<std::int64_t>(*rc::gen::inRange(-100, 100)) << shift;
      plane.linear.b = static_cast<std::int64_t>(*rc::gen::inRange(-100, 100)) << shift;
      // The largest values whose floor is depth 0 at the pixel.
      plane.linear.c = step - 1 - *rc::gen::inRange(0, 3) - plane.linear.a * x - plane.linear.b * y;
      fronts.push_back({0, {static_cast<std::uint32_t>(view.planes.size()), true}});
      view.planes.push_back(plane);
    }
    const emit::Context context{any.tree, any.scene, view, plan.positive, segment, layout, options, machine, look};
    RC_ASSERT(emit::may_reach_near(context, fronts, {pixels, 0, 100}));
  }));
}
