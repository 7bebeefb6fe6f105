#include "sim/report/drawing.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "hw/isa/colour_format.h"
#include "hw/kinds/load.h"
#include "sim/engine/engine.h"
#include "sim/engine/run.h"
#include "sim/report/codec.h"
#include "tests/unit/report/bitten_cube.h"

using namespace csgsim;

namespace {

/// Returns the pixels' states after each step.
std::vector<std::vector<std::uint32_t>> replayed(const report::Drawing& drawing) {
  std::vector<std::vector<std::uint32_t>> all;
  std::vector<std::uint32_t> states(std::size_t{drawing.width} * drawing.height, 0);
  for (const report::DrawingStep& step : drawing.steps) {
    report::apply_changes(step.changes, states);
    all.push_back(states);
  }
  return all;
}

std::uint32_t shown(std::uint32_t packed, const isa::Program& program) {
  const auto [red, green, blue] = isa::unpack_colour(packed, program.colour.width);
  return std::uint32_t{red} << 16U | std::uint32_t{green} << 8U | blue;
}

std::vector<std::uint32_t> colours(const std::vector<std::uint32_t>& states) {
  std::vector<std::uint32_t> all;
  all.reserve(states.size());
  for (const std::uint32_t state : states) all.push_back(state >> 1U);
  return all;
}

}  // namespace

TEST_CASE("each step of a drawing has the reference engine's memory and enable bits") {
  const testing::Compiled model = testing::bitten_cube();
  const isa::Program& program = model.program;
  const machines::Machine machine = testing::machine_of(program.shape);
  const report::Drawing drawing = report::record_drawing(program, machine);
  const std::size_t count = program.segments.front().instructions.size();
  REQUIRE(program.segments.size() == 1);
  REQUIRE(drawing.steps.size() > 20);
  CHECK(drawing.steps.size() <= count + 1);
  const std::vector<std::vector<std::uint32_t>> states = replayed(drawing);
  const auto run = engine::make_reference_engine(machine)->begin(program);
  const isa::Field colour = program.colour;
  for (std::size_t i = 1; i < drawing.steps.size(); ++i) {
    run->advance(drawing.steps[i].number, {});
    std::uint64_t enabled = 0;
    for (std::uint32_t y = 0; y < drawing.height; ++y) {
      for (std::uint32_t x = 0; x < drawing.width; ++x) {
        const std::uint32_t expected =
            shown(run->value(colour, x, y), program) << 1U | (run->is_enabled(x, y) ? 1U : 0U);
        enabled += run->is_enabled(x, y) ? 1U : 0U;
        REQUIRE(states[i][std::size_t{y} * drawing.width + x] == expected);
      }
    }
    CHECK(drawing.steps[i].enabled == enabled);
  }
  CHECK(run->is_finished());
  CHECK(drawing.summary.find("after each of the") != std::string::npos);
}

TEST_CASE("the last step of a drawing is the picture on every machine") {
  for (const std::string name : {"pixel-planes-4", "scan-line", "pixel-square", "pixel-planes-5"}) {
    CAPTURE(name);
    const testing::Compiled model = testing::bitten_cube(name);
    const machines::Machine machine = kinds::load(name);
    const observe::Frame frame = testing::draw_on(machine, model.program);
    std::vector<std::uint32_t> expected;
    for (const std::uint32_t packed : frame.colour) expected.push_back(shown(packed, model.program));
    for (const report::DrawingLimits limits :
         {report::DrawingLimits{}, {10, 2000, 700'000, 512}, {10, 9, 700'000, 512}, {10, 2000, 3000, 512}}) {
      const report::Drawing drawing = report::record_drawing(model.program, machine, limits);
      CHECK(colours(replayed(drawing).back()) == expected);
      CHECK(drawing.steps.size() >= 2);
      CHECK(drawing.steps.size() <= limits.steps + 1);
      CHECK(drawing.steps.front().number == 0);
    }
  }
}

TEST_CASE("a thinned drawing is marked as such and its steps are a subset of the full one") {
  const testing::Compiled model = testing::bitten_cube();
  const machines::Machine machine = testing::machine_of(model.program.shape);
  const report::Drawing full = report::record_drawing(model.program, machine);
  const std::vector<std::vector<std::uint32_t>> states = replayed(full);
  const report::Drawing few = report::record_drawing(model.program, machine, {10, 2000, 1500, 512});
  CHECK(few.summary.find("at most 10 instructions") != std::string::npos);
  CHECK(few.summary.find("and 1,500 bytes") != std::string::npos);
  CHECK(few.steps.size() < full.steps.size());
  const std::vector<std::vector<std::uint32_t>> kept = replayed(few);
  for (std::size_t i = 0; i < few.steps.size(); ++i) {
    std::size_t same = 0;
    while (full.steps[same].number != few.steps[i].number) REQUIRE(++same < full.steps.size());
    CHECK(kept[i] == states[same]);
    CHECK(few.steps[i].clocks == full.steps[same].clocks);
    CHECK(few.steps[i].text == full.steps[same].text);
  }
}

TEST_CASE("a thinned drawing keeps every n-th step from the first and the last step") {
  const testing::Compiled model = testing::bitten_cube();
  const machines::Machine machine = testing::machine_of(model.program.shape);
  const report::Drawing all = report::record_drawing(model.program, machine, {10, 2000, 700'000, 512});
  std::set<std::size_t> strides;
  for (std::size_t bytes = 600; bytes < 6'000; bytes += 300) {
    CAPTURE(bytes);
    const report::Drawing few = report::record_drawing(model.program, machine, {10, 2000, bytes, 512});
    std::size_t stride = 1;
    const std::size_t place = few.summary.find("One in ");
    if (place != std::string::npos) stride = std::stoul(few.summary.substr(place + 7));
    strides.insert(stride);
    std::vector<std::uint64_t> expected;
    for (std::size_t i = 0; i < all.steps.size(); ++i) {
      if (i % stride == 0 || i + 1 == all.steps.size()) expected.push_back(all.steps[i].number);
    }
    std::vector<std::uint64_t> kept;
    for (const report::DrawingStep& step : few.steps) kept.push_back(step.number);
    CHECK(kept == expected);
  }
  CHECK(strides.size() >= 3);
}

TEST_CASE("a large picture in a page shows every second pixel and row with a note") {
  const testing::Compiled model = testing::bitten_cube();
  const machines::Machine machine = testing::machine_of(model.program.shape);
  const report::Drawing drawing = report::record_drawing(model.program, machine, {2000, 2000, 700'000, 20});
  CHECK(drawing.width == 20);
  CHECK(drawing.height == 15);
  CHECK(drawing.summary.find("One pixel in 2") != std::string::npos);
  const observe::Frame frame = testing::draw(model.program);
  const std::vector<std::uint32_t> last = replayed(drawing).back();
  for (std::uint32_t y = 0; y < 15; ++y)
    for (std::uint32_t x = 0; x < 20; ++x)
      CHECK((last[y * 20 + x] >> 1U) == shown(frame.colour[std::size_t{y} * 2 * 40 + x * 2], model.program));
}