#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>

#include "hw/isa/opcodes.h"
#include "sim/observe/frame.h"
#include "sim/story/story.h"
#include "tests/oracle/random_model.h"
#include "tests/support/drawing.h"

using namespace csgsim;
using isa::Opcode;
using story::EventKind;
using story::Fate;

namespace {

constexpr std::uint32_t side = 20;

testing::Compiled compile(const std::string& csg) {
  testing::Setup setup{{{30, -45, 35}, {0, 0, 0}, view::Projection::orthographic}, {}, 160};
  setup.sampling.width = side;
  setup.sampling.height = side;
  return testing::compile_text(csg, setup);
}

story::Story explain_pixel(const isa::Program& program, std::uint32_t x, std::uint32_t y) {
  return story::StoryBuilder(program, testing::machine_of(program.shape)).story_of(x, y);
}

/// Returns the visible surface, if any.
std::optional<story::Event> seen_surface(const story::Story& story) {
  for (const story::Attempt& attempt : story.attempts)
    if (attempt.fate == Fate::seen) return story.events[attempt.first_event];
  return std::nullopt;
}

isa::Instruction& instruction(isa::Program& program, std::uint64_t number) {
  return program.segments[0].instructions[number];
}

const char* const notched =
    "difference(){cube(size=[8,8,8],center=true);"
    "multmatrix([[1,0,0,3],[0,1,0,-3],[0,0,1,3],[0,0,0,1]]){sphere($fn=12,$fa=12,$fs=2,r=5);}}";

}  // namespace

TEST_CASE("a story names the deciding plane whose offset is wrong by one depth step") {
  CHECK(rc::check([] {
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    testing::Compiled compiled = compile(testing::random_model(seed, 1 + static_cast<unsigned>(seed % 7)));
    const auto x = static_cast<std::uint32_t>(*rc::gen::inRange(0, 20));
    const auto y = static_cast<std::uint32_t>(*rc::gen::inRange(0, 20));
    const story::Story right = explain_pixel(compiled.program, x, y);
    const auto surface = seen_surface(right);
    if (!surface || !surface->decision || surface->decision->instruction.linear.width == 0) return;
    const std::uint64_t fault = surface->decision->number;
    isa::Linear& plane = instruction(compiled.program, fault).linear;
    // Shifted towards the extreme, so that the plane still decides.
    const std::int64_t step = surface->decision->instruction.opcode == Opcode::keep_min ? -1 : 1;
    plane.c += step * (std::int64_t{1} << plane.shift);
    const story::Story wrong = explain_pixel(compiled.program, x, y);
    if (wrong.depth == right.depth || wrong.owner != right.owner) return;
    const auto pointed = seen_surface(wrong);
    RC_ASSERT(pointed.has_value() && pointed->decision.has_value());
    RC_ASSERT(pointed->decision->number == fault);
    RC_ASSERT(pointed->decision->value == right.depth + step);
  }));
}

TEST_CASE("a story identifies an inverted comparison where it removes a surface") {
  testing::Compiled compiled = compile(notched);
  isa::Program& program = compiled.program;
  // The back of the notch is inside the cube; the first comparison with a plane of the cube shows it.
  const auto& instructions = program.segments[0].instructions;
  const auto found = std::find_if(instructions.begin(), instructions.end(), [](const isa::Instruction& one) {
    return one.origin.purpose == isa::Purpose::classify && one.origin.primitive == 1 && one.origin.node == 0 &&
           one.opcode == Opcode::linear_gt;
  });
  REQUIRE(found != instructions.end());
  const auto fault = static_cast<std::uint64_t>(found - instructions.begin());
  unsigned pointed = 0;
  for (std::uint32_t y = 0; y < side; ++y) {
    for (std::uint32_t x = 0; x < side; ++x) {
      if (explain_pixel(program, x, y).owner != 1) continue;
      isa::Program faulty = program;
      instruction(faulty, fault).opcode = Opcode::linear_le;
      const story::Story story = explain_pixel(faulty, x, y);
      REQUIRE(story.owner == observe::no_owner);
      const story::Attempt& notch = story.attempts.back();
      REQUIRE(notch.primitive == 1);
      REQUIRE(notch.fate == Fate::classified);
      REQUIRE(notch.deciding_comparison.has_value());
      const auto& cut = story.events[*notch.deciding_comparison].cut;
      REQUIRE(cut.has_value());
      CHECK(cut->number == fault);
      ++pointed;
    }
  }
  CHECK(pointed > 10);
}

TEST_CASE("a story identifies a depth test with exchanged fields") {
  testing::Compiled compiled = compile(notched);
  isa::Program& program = compiled.program;
  const auto& instructions = program.segments[0].instructions;
  const auto found = std::find_if(instructions.begin(), instructions.end(),
                                  [](const isa::Instruction& one) { return one.opcode == Opcode::field_lt; });
  REQUIRE(found != instructions.end());
  const auto fault = static_cast<std::uint64_t>(found - instructions.begin());
  const std::uint32_t x = 9;
  std::uint32_t y = 0;
  while (y < side && explain_pixel(program, x, y).owner != 0) ++y;
  REQUIRE(y < side);
  std::swap(instruction(program, fault).fields[0], instruction(program, fault).fields[1]);
  const story::Story wrong = explain_pixel(program, x, y);
  CHECK(wrong.owner == observe::no_owner);
  REQUIRE_FALSE(wrong.attempts.empty());
  CHECK(wrong.attempts.front().fate == Fate::refused);
  const auto& cut = wrong.events[wrong.attempts.front().deciding_event].cut;
  REQUIRE(cut.has_value());
  CHECK(cut->number == fault);
}

TEST_CASE("a story reports an instruction's width that is too small for the pixel's value") {
  testing::Compiled compiled = compile("cube(size=[8,8,8],center=true);");
  const auto surface = seen_surface(explain_pixel(compiled.program, 10, 10));
  REQUIRE(surface.has_value());
  REQUIRE(surface->decision.has_value());
  CHECK_FALSE(surface->misfit.has_value());
  instruction(compiled.program, surface->decision->number).linear.width = 22;
  instruction(compiled.program, surface->decision->number).linear.shift = 0;
  const story::Story wrong = explain_pixel(compiled.program, 10, 10);
  REQUIRE_FALSE(wrong.attempts.empty());
  const auto& misfit = wrong.events[wrong.attempts.front().first_event].misfit;
  REQUIRE(misfit.has_value());
  CHECK(misfit->number == surface->decision->number);
}
