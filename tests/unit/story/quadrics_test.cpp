#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "host/emit/compile.h"
#include "host/read/read.h"
#include "hw/isa/facts.h"
#include "hw/isa/opcodes.h"
#include "hw/kinds/load.h"
#include "sim/engine/engine.h"
#include "sim/judges/explain.h"
#include "sim/observe/frame.h"
#include "sim/story/phrases.h"
#include "sim/story/story.h"
#include "sim/story/story_json.h"
#include "sim/story/story_text.h"
#include "tests/oracle/random_model.h"

using namespace csgsim;

namespace {

struct Row {
  std::string machine;
  emit::Strategy strategy = emit::Strategy::stack;
  emit::Colouring colouring = emit::Colouring::rebroadcast;
};

constexpr std::uint32_t width = 26;
constexpr std::uint32_t height = 20;

struct Drawn {
  model::Tree tree;
  facet::Geometry scene;
  view::Camera camera;
  view::View view;
  machines::Machine machine;
  isa::Program program;
};

Drawn draw(const Row& row, const std::string& csg, view::Projection projection) {
  machines::Machine machine = kinds::load(row.machine);
  machines::set_picture_size(machine, {width, height});
  model::Tree tree = read::read_csg_text(csg, "random");
  facet::Geometry scene = facet::make_geometry(tree, {.exact_curves = true, .min_round_sides = 0});
  view::Sampling sampling;
  sampling.width = width;
  sampling.height = height;
  const view::Camera camera{{9, -13.5, 10.5}, {0, 0, 0}, projection};
  view::View view = view::make_view(scene, tree, camera, sampling);
  emit::Options options;
  options.strategy = row.strategy;
  options.colouring = row.colouring;
  isa::Program program = emit::compile(tree, scene, view, machine, options);
  return {std::move(tree), std::move(scene), camera, std::move(view), std::move(machine), std::move(program)};
}

observe::Frame frame_of(const Drawn& drawn) {
  observe::FrameObserver frame(drawn.program);
  const std::array<engine::Observer*, 1> observers{&frame};
  engine::make_functional_engine(drawn.machine)->run(drawn.program, observers);
  return std::move(frame).frame();
}

/// Returns the instruction with this number, counted over segments.
const isa::Instruction& instruction(const isa::Program& program, std::uint64_t number) {
  std::size_t segment = 0;
  while (number >= program.segments[segment].instructions.size())
    number -= program.segments[segment++].instructions.size();
  return program.segments[segment].instructions[number];
}

/// Recomputes a depth from the coefficients of the instructions that it names.
void check_working(const Drawn& drawn, const story::Story& story, const story::QuadricDepth& depth) {
  const isa::Region& region = drawn.program.segments[story.segments.at(0).segment].region;
  const std::int64_t x = story.x - region.x;
  const std::int64_t y = story.y - region.y;
  const isa::Instruction& squares = instruction(drawn.program, depth.load_number - 1);
  const isa::Instruction& load = instruction(drawn.program, depth.load_number);
  REQUIRE(squares.opcode == isa::Opcode::squares);
  CHECK(squares == depth.squares);
  CHECK(load == depth.load);
  const std::int64_t sum = squares.linear.a * x * x + squares.linear.b * x * y + squares.linear.c * y * y +
                           load.linear.a * x + load.linear.b * y + load.linear.c;
  CHECK((sum >> load.linear.shift) == depth.discriminant);
  CHECK(instruction(drawn.program, depth.root_number).opcode == isa::Opcode::root);
  CHECK(instruction(drawn.program, depth.root_number).fields[0] == depth.field);
  const auto q = static_cast<std::int64_t>(depth.root);
  CHECK(q * q <= depth.discriminant);
  CHECK((q + 1) * (q + 1) > depth.discriminant);
  const isa::Instruction& made = instruction(drawn.program, depth.depth_number);
  CHECK(made.opcode == (depth.is_far ? isa::Opcode::linear_plus : isa::Opcode::linear_minus));
  CHECK(((made.linear.a * x + made.linear.b * y + made.linear.c) >> made.linear.shift) == depth.middle);
  CHECK(depth.offset % depth.root == 0);
  const auto farthest = (std::int64_t{1} << drawn.program.facts->compile.z_bits) - 1;
  const auto offset = static_cast<std::int64_t>(depth.offset);
  const std::int64_t at = depth.is_far ? depth.middle + offset : depth.middle - offset;
  CHECK(std::clamp<std::int64_t>(at, 0, farthest) == story.depth);
}

constexpr const char* bowl =
    "difference(){cylinder($fn=40,$fa=12,$fs=2,h=6,r1=5,r2=5,center=true);"
    "multmatrix([[1,0,0,0],[0,1,0,0],[0,0,1,3],[0,0,0,1]]){sphere($fn=40,$fa=12,$fs=2,r=4);}}";

}  // namespace

TEST_CASE("the story of random quadric models has the owners and depths of the picture") {
  const std::vector<Row> rows{
      {"pixel-powers+array.memory_bits=200"},
      {"pixel-powers+array.memory_bits=200", emit::Strategy::products},
      {"pixel-powers+array.memory_bits=800", emit::Strategy::stored},
      {"pixel-powers+array.memory_bits=200", emit::Strategy::parallel, emit::Colouring::field},
      {"pixel-square+evaluator.degree=2+array.memory_bits=200+divider.kind=host", emit::Strategy::list},
      {"scan-line+evaluator.degree=2+cells.words=8", emit::Strategy::stack, emit::Colouring::field}};
  std::minstd_rand random(11);
  unsigned by_quadric = 0;
  unsigned by_plane = 0;
  std::uint64_t seed = 500;
  for (const Row& row : rows) {
    CAPTURE(row.machine);
    CAPTURE(emit::name_of(row.strategy));
    for (unsigned model = 0; model < 16; ++model) {
      ++seed;
      CAPTURE(seed);
      const std::string csg = testing::random_model(seed, 2 + static_cast<unsigned>(seed % 9));
      const Drawn drawn =
          draw(row, csg, seed % 2 == 0 ? view::Projection::orthographic : view::Projection::perspective);
      const observe::Frame frame = frame_of(drawn);
      const judges::Explainer exact(drawn.tree, drawn.scene, drawn.camera, drawn.program);
      const story::HalfspaceFinder finder(drawn.tree, drawn.scene, drawn.view);
      const story::Subject subject{drawn.program, &finder};
      const story::StoryBuilder builder(drawn.program, drawn.machine);
      for (unsigned pixel = 0; pixel < 80; ++pixel) {
        const std::uint32_t x = static_cast<std::uint32_t>(random()) % width;
        const std::uint32_t y = static_cast<std::uint32_t>(random()) % height;
        CAPTURE(x);
        CAPTURE(y);
        const story::Story story = builder.story_of(x, y);
        CHECK(story.owner == frame.owner[std::size_t{y} * width + x]);
        CHECK(story.depth == frame.depth[std::size_t{y} * width + x]);
        CHECK(exact.may_show(x, y, story.owner, story.depth));
        const auto seen = std::find_if(story.attempts.begin(), story.attempts.end(),
                                       [](const story::Attempt& one) { return one.fate == story::Fate::seen; });
        CHECK((seen == story.attempts.end()) == (story.owner == observe::no_owner));
        if (seen == story.attempts.end()) continue;
        const story::Event& surface = story.events[seen->first_event];
        REQUIRE(surface.decision.has_value());
        if (!surface.decision->quadric) {
          ++by_plane;
          continue;
        }
        ++by_quadric;
        check_working(drawn, story, *surface.decision->quadric);
        const auto quadric = story::quadric_of(subject, *surface.decision);
        REQUIRE(quadric.has_value());
        CHECK(quadric->primitive == story.owner);
      }
    }
  }
  CHECK(by_quadric > 300);
  CHECK(by_plane > 100);
}

TEST_CASE("a story's text and JSON name the visible quadric and its side and root bits") {
  const Drawn drawn = draw({"pixel-powers"}, bowl, view::Projection::orthographic);
  const story::HalfspaceFinder finder(drawn.tree, drawn.scene, drawn.view);
  const story::Subject subject{drawn.program, &finder};
  const observe::Frame frame = frame_of(drawn);
  const auto at = static_cast<std::uint32_t>(std::ranges::find(frame.owner, 1U) - frame.owner.begin());
  REQUIRE(at < frame.owner.size());
  const story::Story story = story::StoryBuilder(drawn.program, drawn.machine).story_of(at % width, at / width);
  const std::string text = story::text_of(subject, story);
  CHECK(text.find("far depth of quadric 1 of 1 of p1 sphere@1:") != std::string::npos);
  CHECK(text.find(": ellipsoid about (0, 0, 3)\n") != std::string::npos);
  const auto json = story::to_json(subject, story);
  const auto event = std::ranges::find_if(
      json["events"], [](const auto& one) { return one["what"] == "surface" && one["primitive"]["index"] == 1; });
  REQUIRE(event != json["events"].end());
  const auto& decision = (*event)["decision"];
  CHECK(decision["quadric"]["kind"] == "ellipsoid");
  CHECK(decision["quadric"]["primitive"]["index"] == 1);
  CHECK(decision["quadric"]["origin"][2] == doctest::Approx(3));
  CHECK(decision["worked_out"]["side"] == "far");
  const auto& root = decision["worked_out"]["root"];
  CHECK(text.find("root " + std::to_string(root["value"].get<std::uint64_t>()) + " in ") != std::string::npos);
  // The field of the root has twice its bits plus one, and is the one that the instruction names.
  CHECK(root["width"].get<unsigned>() % 2 == 1);
  const isa::Field field = instruction(drawn.program, root["instruction"]).fields[0];
  CHECK(field.base == root["base"]);
  CHECK(field.width == root["width"]);
}

TEST_CASE("a negative discriminant of a quadric removes a pixel outside its outline") {
  const Drawn drawn = draw({"pixel-powers"}, "sphere($fn=40,$fa=12,$fs=2,r=4);", view::Projection::orthographic);
  const story::HalfspaceFinder finder(drawn.tree, drawn.scene, drawn.view);
  const story::Subject subject{drawn.program, &finder};
  const observe::Frame frame = frame_of(drawn);
  const view::PixelRect& box = drawn.view.extents[0].pixels;
  const auto x = static_cast<std::uint32_t>(box.x0);
  const auto y = static_cast<std::uint32_t>(box.y0);
  REQUIRE(frame.owner[std::size_t{y} * width + x] == observe::no_owner);
  const story::Story story = story::StoryBuilder(drawn.program, drawn.machine).story_of(x, y);
  const auto cut =
      std::ranges::find_if(story.events, [](const story::Event& one) { return one.cut && one.cut->squares; });
  REQUIRE(cut != story.events.end());
  CHECK(cut->cut->value < 0);
  CHECK(story::geometry_text(subject, *cut->cut).starts_with("outline of quadric 1 of 1 of p0 sphere@1:1: ellipsoid"));
  CHECK(story::decision_text(drawn.program, *cut->cut).find(" squares ") != std::string::npos);
  CHECK(story.attempts.at(0).fate == story::Fate::outside);
}
