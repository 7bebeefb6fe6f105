#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "host/read/read.h"
#include "hw/base/error.h"
#include "hw/isa/facts.h"
#include "hw/isa/opcodes.h"
#include "hw/kinds/load.h"
#include "sim/judges/explain.h"
#include "sim/story/story.h"
#include "tests/oracle/pixel_oracle.h"
#include "tests/oracle/random_model.h"
#include "tests/support/drawing.h"

using namespace csgsim;

namespace {

struct Row {
  std::string machine;
  emit::Strategy strategy = emit::Strategy::stack;
  emit::Colouring colouring = emit::Colouring::rebroadcast;
  unsigned stack_bits = emit::min_stack_bits;
};

constexpr std::uint32_t width = 26;
constexpr std::uint32_t height = 20;
constexpr unsigned models = 9;   // per row
constexpr unsigned pixels = 36;  // per model

/// Enlarges memory for the depths of all primitives of a model.
std::string with_more_memory(const std::string& machine) {
  return machine + (machine.starts_with("scan-line") ? "+cells.words=24" : "+array.memory_bits=768");
}

/// Every strategy on every host-divided machine, and the dividers' strategy on machines with dividers.
std::vector<Row> rows() {
  using emit::Colouring;
  using emit::Strategy;
  std::vector<Row> all;
  for (const std::string machine :
       {"pixel-planes-4+array.memory_bits=160", "pixel-planes-4+array.memory_bits=160+global_or.present=0",
        "scan-line+cells.words=6", "pixel-square+array.memory_bits=160+divider.kind=host",
        "pixel-planes-5+divider.kind=host", "pixel-planes-5"}) {
    for (const Strategy strategy : emit::default_strategies()) {
      all.push_back(
          {strategy == Strategy::stored ? with_more_memory(machine) : machine, strategy, Colouring::rebroadcast});
    }
    all.push_back({machine, Strategy::stack, Colouring::field});
    all.push_back({machine, Strategy::bits, Colouring::field, 3});
    all.push_back({machine, Strategy::bits, Colouring::rebroadcast, 5});
  }
  for (const std::string machine : {"pixel-square+array.memory_bits=160", "pixel-planes-5+divider.kind=corners",
                                    "multi-processor+pixel.memory_bits=160"}) {
    all.push_back({machine, Strategy::stack, Colouring::rebroadcast});
    all.push_back({machine, Strategy::stack, Colouring::field});
  }
  return all;
}

struct Drawn {
  testing::Compiled compiled;
  view::Camera camera;
  machines::Machine machine;
};

Drawn draw(const Row& row, std::uint64_t seed) {
  machines::Machine machine = kinds::load(row.machine);
  machines::set_picture_size(machine, {width, height});
  model::Tree tree = read::read_csg_text(testing::random_model(seed, 2 + static_cast<unsigned>(seed % 9)), "random");
  facet::Geometry scene = facet::make_geometry(tree);
  view::Sampling sampling;
  sampling.width = width;
  sampling.height = height;
  const view::Camera camera{
      {9, -13.5, 10.5}, {0, 0, 0}, seed % 2 == 0 ? view::Projection::orthographic : view::Projection::perspective};
  view::View view = view::make_view(scene, tree, camera, sampling);
  emit::Options options;
  options.strategy = row.strategy;
  options.colouring = row.colouring;
  options.stack_bits = row.stack_bits;
  isa::Program program = emit::compile(tree, scene, view, machine, options);
  return {{std::move(tree), std::move(scene), std::move(view), std::move(program)}, camera, std::move(machine)};
}

/// Returns the instruction with this number, counted over segments.
const isa::Instruction& instruction(const isa::Program& program, std::uint64_t number) {
  std::size_t segment = 0;
  while (number >= program.segments[segment].instructions.size())
    number -= program.segments[segment++].instructions.size();
  return program.segments[segment].instructions[number];
}

/// Returns the depth last stored in the field.
std::int64_t stored_depth(const isa::Program& program, const story::Story& story, isa::Field field) {
  std::int64_t depth = -1;
  for (const story::Event& event : story.events) {
    if (event.kind != story::EventKind::stored) continue;
    for (const story::Change& change : event.changes)
      if (change.field == field) depth = static_cast<std::int64_t>(change.after);
  }
  CHECK(isa::find_field(program, isa::FieldRole::stored).width == field.width);
  return depth;
}

/// Returns the depth that the instruction credited with the owner's surface computes.
std::int64_t depth_by(const isa::Program& program, const story::Story& story, std::uint64_t number) {
  const isa::Instruction& put = instruction(program, number);
  if (put.opcode == isa::Opcode::copy) return stored_depth(program, story, put.fields[1]);
  if (put.linear.width == 0) return static_cast<std::int64_t>(put.constant);
  const isa::Region& region = program.segments[story.segments.at(0).segment].region;
  const std::int64_t x = story.x - region.x;
  const std::int64_t y = story.y - region.y;
  return (put.linear.a * x + put.linear.b * y + put.linear.c) >> put.linear.shift;
}

void check_cause(const isa::Program& program, const story::Story& story) {
  for (const story::Event& event : story.events) CHECK_FALSE((event.cut && event.enabled_after));
  const auto seen = std::find_if(story.attempts.rbegin(), story.attempts.rend(),
                                 [](const story::Attempt& one) { return one.fate == story::Fate::seen; });
  if (story.owner == observe::no_owner) {
    CHECK(seen == story.attempts.rend());
    return;
  }
  REQUIRE(seen != story.attempts.rend());
  const story::Event& surface = story.events[seen->first_event];
  REQUIRE(surface.decision.has_value());
  CHECK(depth_by(program, story, surface.decision->number) == story.depth);
  CHECK(std::count_if(story.attempts.begin(), story.attempts.end(),
                      [](const story::Attempt& one) { return one.fate == story::Fate::seen; }) == 1);
}

}  // namespace

TEST_CASE("the story's owner and depth equal the judges' at random pixels on every machine") {
  std::minstd_rand random(7);
  unsigned judged = 0;
  unsigned covered = 0;
  std::uint64_t seed = 100;
  for (const Row& row : rows()) {
    CAPTURE(row.machine);
    CAPTURE(emit::name_of(row.strategy));
    CAPTURE(emit::name_of(row.colouring));
    CAPTURE(row.stack_bits);
    for (unsigned model = 0; model < models; ++model) {
      ++seed;
      CAPTURE(seed);
      const Drawn drawn = draw(row, seed);
      const isa::Program& program = drawn.compiled.program;
      const std::vector<testing::Seen> rules =
          testing::draw_by_rules(drawn.compiled.tree, drawn.compiled.scene, drawn.compiled.view);
      const judges::Explainer exact(drawn.compiled.tree, drawn.compiled.scene, drawn.camera, program);
      const story::StoryBuilder builder(program, drawn.machine);
      for (unsigned pixel = 0; pixel < pixels; ++pixel) {
        const std::uint32_t x = static_cast<std::uint32_t>(random()) % width;
        const std::uint32_t y = static_cast<std::uint32_t>(random()) % height;
        CAPTURE(x);
        CAPTURE(y);
        const story::Story story = builder.story_of(x, y);
        const testing::Seen& seen = rules[std::size_t{y} * width + x];
        CHECK(story.owner == seen.owner);
        CHECK(story.depth == seen.depth);
        CHECK(exact.may_show(x, y, story.owner, story.depth));
        check_cause(program, story);
        ++judged;
        covered += seen.owner != observe::no_owner ? 1U : 0U;
      }
    }
  }
  CHECK(judged >= 10'000);
  CHECK(covered >= 2'000);
}
