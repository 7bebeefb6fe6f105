#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "hw/isa/facts.h"
#include "sim/engine/engine.h"
#include "sim/functional/clocks.h"
#include "sim/story/pixel_run.h"
#include "sim/story/story.h"
#include "sim/story/story_json.h"
#include "sim/story/story_text.h"
#include "tests/support/drawing.h"
#include "tests/support/random_program.h"

using namespace csgsim;

namespace {

constexpr isa::ArrayShape shape{9, 5, 40};

machines::Machine quadratic_machine(const isa::ArrayShape& array) {
  machines::Machine machine = testing::machine_of(array);
  machine.evaluator_degree = 2;
  return machine;
}

/// State of one pixel after an instruction of a run of the whole array.
struct Left {
  std::uint32_t segment = 0;
  std::uint32_t index = 0;
  bool enabled = false;
  std::uint64_t target = 0;
};

class PixelObserver final : public engine::Observer {
 public:
  PixelObserver(const isa::Program& program, std::uint32_t x, std::uint32_t y) : program_(program), x_(x), y_(y) {}

  void after_instruction(const engine::Step& step, const engine::PixelState& state) override {
    const isa::Region region = state.region();
    if (x_ < region.x || y_ < region.y || x_ - region.x >= region.width || y_ - region.y >= region.height) return;
    const std::size_t words = (region.width + 63U) / 64U;
    std::vector<std::uint64_t> enable(words * region.height);
    state.read_enable(enable);
    const std::uint32_t x = x_ - region.x;
    const std::uint32_t y = y_ - region.y;
    Left one{step.segment, step.index, (enable[y * words + x / 64U] >> x % 64U & 1U) != 0, 0};
    if (isa::operands_of(step.instruction.opcode)[0] == isa::OperandKind::target) {
      const isa::Field target = story::enclosing_named_field(program_, step.instruction.fields[0]);
      std::vector<std::uint32_t> values(std::size_t{region.width} * region.height);
      for (unsigned at = 0; at < target.width; at += isa::max_field_width) {
        const unsigned width = std::min<unsigned>(target.width - at, isa::max_field_width);
        state.read_field({static_cast<std::uint16_t>(target.base + at), static_cast<std::uint16_t>(width)}, values);
        one.target |= std::uint64_t{values[std::size_t{y} * region.width + x]} << at;
      }
    }
    left.push_back(one);
  }

  std::vector<Left> left;

 private:
  const isa::Program& program_;
  std::uint32_t x_;
  std::uint32_t y_;
};

}  // namespace

TEST_CASE("a run of one pixel equals that of the whole array for random Programs") {
  CHECK(rc::check([] {
    const isa::Program program = *test::arbitrary_program(shape, 40, 2);
    const auto x = static_cast<std::uint32_t>(*rc::gen::inRange(0, 9));
    const auto y = static_cast<std::uint32_t>(*rc::gen::inRange(0, 5));
    const machines::Machine machine = quadratic_machine(program.shape);
    PixelObserver observer(program, x, y);
    const std::array<engine::Observer*, 1> observers{&observer};
    engine::make_reference_engine(machine)->run(program, observers);
    const story::PixelRun run = story::run_pixel(program, functional::make_run_record(program, machine).skips, x, y);
    RC_ASSERT(run.steps.size() == observer.left.size());
    for (std::size_t i = 0; i < run.steps.size(); ++i) {
      RC_ASSERT(run.steps[i].segment == observer.left[i].segment);
      RC_ASSERT(run.steps[i].index == observer.left[i].index);
      RC_ASSERT(run.steps[i].enabled_after == observer.left[i].enabled);
      RC_ASSERT(run.steps[i].after == observer.left[i].target);
    }
  }));
}

TEST_CASE("a story of any Program can be written as text and as JSON") {
  CHECK(rc::check([] {
    const isa::Program program = *test::arbitrary_program(shape, 40, 2);
    const story::Subject subject{program, nullptr};
    const story::Story story = story::StoryBuilder(program, quadratic_machine(program.shape)).story_of(4, 2);
    RC_ASSERT(!text_of(subject, story).empty());
    RC_ASSERT(story::to_json(subject, story).dump().size() > 2U);
    for (std::uint32_t p = 0; p < program.facts->primitives.size(); ++p)
      RC_ASSERT(!text_of(subject, story, story::why_not(subject, story, p)).empty());
  }));
}
