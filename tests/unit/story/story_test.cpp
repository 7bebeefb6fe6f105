#include "sim/story/story.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/scene/scene.h"
#include "hw/isa/field_role.h"
#include "hw/isa/text.h"
#include "hw/machines/timeline.h"
#include "sim/engine/engine.h"
#include "sim/functional/clocks.h"
#include "sim/observe/frame.h"
#include "sim/story/pixel_run.h"
#include "sim/story/story_json.h"
#include "sim/story/story_text.h"
#include "sim/story/why_not.h"
#include "tests/support/drawing.h"
#include "tests/support/error_of.h"
#include "tests/unit/effects/effect_picture.h"

using namespace csgsim;
using story::EventKind;
using story::Fate;
using testing::box_text;

namespace {

/// A view along +y of 8 columns and 6 rows: pixel (x, y) looks through the model's (x + 0.5, any, -y - 0.5). All models
/// extend from y = 0 to y = 5, so that a point at y has depth 1 + (2^20 - 4) y / 5, rounded down.
constexpr std::uint32_t at_1 = 209715;
constexpr std::uint32_t at_2 = 419429;
constexpr std::uint32_t at_3 = 629144;

/// A box at the far left that sets the range of depths.
const std::string first = box_text({0, 0, -6}, {0.75, 5, -5.25});

const std::string big = box_text({1, 2, -5}, {5, 4.5, -1});
const std::string near_box = box_text({3, 1, -4}, {7, 1.5, -2});
const std::string blind_hole = "difference(){" + big + box_text({2, 0.5, -4}, {4, 3, -2}) + "}";
const std::string through_hole = "difference(){" + big + box_text({2, 0.5, -4}, {4, 4.75, -2}) + "}";

struct PixelCase {
  testing::Compiled compiled;
  machines::Machine machine;
  std::uint32_t x = 0;
  std::uint32_t y = 0;

  [[nodiscard]] story::Story story() const { return story::StoryBuilder(compiled.program, machine).story_of(x, y); }
};

PixelCase draw_case(const std::string& csg, std::uint32_t x, std::uint32_t y,
                    emit::Strategy strategy = emit::Strategy::stack) {
  testing::Setup setup = testing::front_view(8, 6, {});
  setup.options.strategy = strategy;
  testing::Compiled compiled = testing::compile_text("union(){" + first + csg + "}", setup);
  machines::Machine machine = testing::machine_of(compiled.program.shape);
  return {std::move(compiled), std::move(machine), x, y};
}

/// Returns the attempt to draw a primitive.
const story::Attempt& find_attempt(const story::Story& story, std::uint32_t primitive) {
  const auto found = std::find_if(story.attempts.begin(), story.attempts.end(),
                                  [&](const story::Attempt& one) { return one.primitive == primitive; });
  REQUIRE(found != story.attempts.end());
  return *found;
}

/// Returns the first event of this kind in the attempt.
const story::Event& find_event(const story::Story& story, const story::Attempt& attempt, EventKind kind) {
  for (std::size_t i = attempt.first_event; i <= attempt.last_event; ++i)
    if (story.events[i].kind == kind) return story.events[i];
  FAIL("the attempt has no such event");
  return story.events.front();
}

/// Story of one of two pixels on which a surface is drawn, followed by more instructions.
story::Story by_hand(const std::string& more, std::uint32_t x) {
  const isa::Program program = isa::parse(
      ".array width=2 height=1 memory_bits=64\n.frame colour_base=16 colour_bits=6\n"
      ".field Z2 [0+:8] depth\n.field Z1 [8+:8] candidate_depth\n.field colour [16+:6] colour\n"
      ".primitive \"a\"\n.segment width=2 height=1\n"
      "enable_all; setup\nset_constant Z2, 255; setup\n"
      "enable_all; render p0\nload_linear Z1, 5 (w10); render p0\nkeep_max Z1, x + 5 (w10); render p0\n"
      "field_lt Z1, Z2; merge p0\ncopy Z2, Z1; merge p0\n" +
          more,
      "by hand");
  return story::StoryBuilder(program, testing::machine_of(program.shape)).story_of(x, 0);
}

std::string glass(const std::string& csg) { return testing::tinted({0.2, 0.5, 0.9}, 0.4, csg); }

/// Returns the only visible surface.
nlohmann::json seen_surface(const nlohmann::json& story) {
  std::vector<nlohmann::json> seen;
  for (const nlohmann::json& one : story["surfaces"])
    if (one["fate"] == "seen") seen.push_back(one);
  CHECK(seen.size() == 1);
  return seen.empty() ? nlohmann::json() : seen.front();
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("a nearer box drawn later is merged over the farther one") {
  const PixelCase pixel = draw_case(big + near_box, 4, 2);
  const story::Story story = pixel.story();
  CHECK(story.owner == 2);
  CHECK(story.depth == at_1);
  const story::Attempt& far = find_attempt(story, 1);
  CHECK(far.fate == Fate::covered);
  CHECK(story.events[far.deciding_event].origin.primitive == 2);
  const story::Event& surface = find_event(story, far, EventKind::surface);
  REQUIRE(surface.decision.has_value());
  CHECK(surface.decision->value == at_2);
  const story::Attempt& near = find_attempt(story, 2);
  CHECK(near.fate == Fate::seen);
  const story::Event& merge = find_event(story, near, EventKind::merge);
  CHECK(merge.owner_before == 1);
  CHECK(merge.owner_after == 2);
  const story::Change* const z2 = merge.change_of(pixel.compiled.program, isa::FieldRole::depth);
  REQUIRE(z2 != nullptr);
  CHECK(z2->before == at_2);
  CHECK(z2->after == at_1);
}

TEST_CASE("a farther box drawn later fails the depth test and both depths are reported") {
  const PixelCase pixel = draw_case(near_box + big, 4, 2);
  const story::Story story = pixel.story();
  CHECK(story.owner == 1);
  const story::Attempt& far = find_attempt(story, 2);
  REQUIRE(far.fate == Fate::behind);
  const story::Event& test = story.events[far.deciding_event];
  REQUIRE(test.decision.has_value());
  CHECK(test.decision->first_operand == at_2);
  CHECK(test.decision->second_operand == at_1);
  CHECK(test.owner_before == 1);
}

TEST_CASE("through a hole the background is seen because front and back are removed") {
  for (const emit::Strategy strategy : emit::default_strategies()) {
    CAPTURE(emit::name_of(strategy));
    const story::Story story = draw_case(through_hole, 3, 2, strategy).story();
    CHECK(story.owner == observe::no_owner);
    CHECK(story.depth == (1U << 20U) - 1);
    const story::Attempt& front = find_attempt(story, 1);
    REQUIRE(front.fate == Fate::classified);
    REQUIRE(front.deciding_comparison.has_value());
    const story::Event& comparison = story.events[*front.deciding_comparison];
    CHECK(comparison.origin.node == 2);
    CHECK_FALSE(comparison.cut.has_value());
    const story::Attempt& back = find_attempt(story, 2);
    REQUIRE(back.fate == Fate::classified);
    REQUIRE(back.deciding_comparison.has_value());
    CHECK(story.events[*back.deciding_comparison].origin.node == 1);
    CHECK(story.events[*back.deciding_comparison].cut.has_value());
  }
}

TEST_CASE("in a blind hole the back of the subtracted solid is seen") {
  const PixelCase pixel = draw_case(blind_hole, 3, 2);
  const story::Story story = pixel.story();
  CHECK(story.owner == 2);
  CHECK(story.depth == at_3);
  CHECK(find_attempt(story, 1).fate == Fate::classified);
  const story::Attempt& wall = find_attempt(story, 2);
  CHECK(wall.fate == Fate::seen);
  const story::Event& surface = find_event(story, wall, EventKind::surface);
  REQUIRE(surface.decision.has_value());
  const story::HalfspaceFinder finder(pixel.compiled.tree, pixel.compiled.scene, pixel.compiled.view);
  const auto found = finder.find(surface.decision->instruction, pixel.compiled.program.segments[0].region);
  REQUIRE(found.has_value());
  CHECK(found->primitive == 2);
  CHECK(found->count == 6);
  CHECK(found->normal == glm::dvec3(0, 1, 0));
  CHECK(found->distance == doctest::Approx(3));
}

TEST_CASE("the story of a pixel beside a box names the side that removes it") {
  const PixelCase pixel = draw_case(big, 6, 2);
  const story::Story story = pixel.story();
  CHECK(story.owner == observe::no_owner);
  const story::Attempt& beside = find_attempt(story, 1);
  CHECK(beside.fate == Fate::outside);
  const story::Event& surface = story.events[beside.first_event];
  REQUIRE(surface.cut.has_value());
  // Columns 1 to 4: 4 - x is not negative there and is -2 here.
  CHECK(surface.cut->instruction.linear.a == -1);
  CHECK(surface.cut->value == -2);
}

TEST_CASE("explain --why-not gives the reason for each hidden or pruned primitive") {
  const auto answer = [](const PixelCase& pixel, std::uint32_t primitive) {
    const story::HalfspaceFinder finder(pixel.compiled.tree, pixel.compiled.scene, pixel.compiled.view);
    const story::Subject subject{pixel.compiled.program, &finder};
    const story::Story story = pixel.story();
    return text_of(subject, story, story::why_not(subject, story, primitive));
  };
  CHECK(contains(answer(draw_case(big + near_box, 4, 2), 1), "p2 cube@3:56 was merged over it"));
  CHECK(contains(answer(draw_case(near_box + big, 4, 2), 2), "behind p1 cube"));
  CHECK(contains(answer(draw_case(through_hole, 3, 2), 1), "classified out: it is in p2 cube"));
  CHECK(contains(answer(draw_case(through_hole, 3, 2), 2), "classified out: it is outside p1 cube"));
  CHECK(contains(answer(draw_case(through_hole, 3, 2), 2), "normal (0, 1, 0), distance 4.5"));
  CHECK(contains(answer(draw_case(big, 6, 2), 1), "the pixel is outside its outline: i"));
  CHECK(contains(answer(draw_case(big, 2, 2), 1), "the pixel shows "));
  const std::string beyond = box_text({20, 1, -4}, {21, 2, -3});
  CHECK(contains(answer(draw_case(big + beyond, 2, 2), 2), "nowhere in the picture"));
}

TEST_CASE("explain --why-not states that no instruction draws a pruned primitive") {
  // The wide box fills its rectangle and hides a smaller one behind it.
  const PixelCase pixel =
      draw_case(box_text({1, 1, -5.5}, {7.5, 1.5, -0.5}) + box_text({4.25, 2, -3.25}, {5.75, 3, -2.75}), 5, 2);
  const story::Subject subject{pixel.compiled.program, nullptr};
  const story::Story story = pixel.story();
  const story::WhyNot answer = story::why_not(subject, story, 2);
  CHECK_FALSE(answer.is_broadcast);
  CHECK(contains(text_of(subject, story, answer), "no instruction of segment 0 draws p2"));
}

TEST_CASE("a pixel of intersecting boxes is owned by the box of the visible facet") {
  const PixelCase pixel = draw_case("intersection(){" + big + box_text({2, 1.5, -4}, {4, 3.5, -2}) + "}", 3, 2);
  const story::HalfspaceFinder finder(pixel.compiled.tree, pixel.compiled.scene, pixel.compiled.view);
  const story::Subject subject{pixel.compiled.program, &finder};
  const story::Story story = pixel.story();
  CHECK(story.owner == 1);
  CHECK(story.depth == at_2);
  const story::WhyNot answer = story::why_not(subject, story, 2);
  CHECK(answer.drawn_as == 1);
  CHECK(contains(text_of(subject, story, answer), "drawn with p1 cube"));
  CHECK(contains(text_of(subject, story, answer), "the facet visible here belongs to p1"));
}

TEST_CASE("a story's JSON names the intersecting box whose facet is seen and its partners") {
  const PixelCase pixel = draw_case("intersection(){" + box_text({2, 1.5, -4}, {4, 3.5, -2}) + big + "}", 3, 2);
  const story::Subject subject{pixel.compiled.program, nullptr};
  const nlohmann::json json = story::to_json(subject, pixel.story());
  CHECK(json["owner"]["index"] == 2);
  const nlohmann::json seen = seen_surface(json);
  CHECK(seen["primitive"] == json["owner"]);
  CHECK(seen["drawn_as"]["index"] == 1);
  CHECK(contains(story::text_of(subject, pixel.story()), "drawn with p1 cube"));
}

TEST_CASE("the story of a pixel names the nearest glass and the box seen through it") {
  const std::string pane = box_text({3, 1, -4}, {7, 1.5, -2});
  const std::string behind = box_text({3, 1.75, -4}, {7, 1.8, -2});
  const PixelCase pixel = draw_case(big + glass(pane) + glass(behind), 4, 2);
  const story::Subject subject{pixel.compiled.program, nullptr};
  const story::Story story = pixel.story();
  CHECK(story.owner == 2);
  CHECK(story.depth == at_1);
  CHECK(story.opaque_owner == 1);
  CHECK(story.opaque_depth == at_2);
  CHECK(find_attempt(story, 1).fate == Fate::blended);
  CHECK(std::count_if(story.attempts.begin(), story.attempts.end(),
                      [](const story::Attempt& one) { return one.fate == Fate::blended && one.primitive == 3; }) == 1);
  const nlohmann::json json = story::to_json(subject, story);
  CHECK(json["owner"]["index"] == 2);
  CHECK(json["depth"]["steps"] == at_1);
  CHECK(json["opaque"]["owner"]["index"] == 1);
  CHECK(json["opaque"]["depth"]["steps"] == at_2);
  CHECK(seen_surface(json)["primitive"] == json["owner"]);
  const std::string text = story::text_of(subject, story);
  CHECK(contains(text, "shows p2 cube"));
  CHECK(contains(text, "through   p1 cube"));
  CHECK(contains(text, "merged; this is the visible surface"));
  const story::WhyNot why_not = story::why_not(subject, story, 1);
  CHECK_FALSE(why_not.is_seen);
  CHECK(contains(text_of(subject, story, why_not), "contributes to the colour, but is not the nearest"));
}

TEST_CASE("the story of a pixel of glass alone has nothing behind the glass") {
  const PixelCase pixel = draw_case(glass(near_box), 4, 2);
  const story::Story story = pixel.story();
  CHECK(story.owner == 1);
  CHECK(story.depth == at_1);
  CHECK(story.opaque_owner == observe::no_owner);
  const story::Subject subject{pixel.compiled.program, nullptr};
  CHECK(story::to_json(subject, story)["opaque"]["owner"].is_null());
  CHECK(contains(story::text_of(subject, story), "through   nothing"));
}

TEST_CASE("the story of each pixel has one visible surface with glass or mirrors or samples") {
  const std::string models = "union(){" + first + big + "intersection(){" + box_text({1, 1.5, -5}, {4, 3.5, -2}) +
                             box_text({2, 1, -6}, {6, 4, -1}) + "}" + glass(near_box) +
                             glass(box_text({0, 0.5, -5}, {5, 0.75, -3})) + "}";
  const std::string mirror = "[[materials]]\nfrom_line = 3\nmirror = 0.5\n";
  for (const std::string& scene : {std::string(), mirror, std::string("[effects.antialias]\nsamples = 2\n"),
                                   std::string("[effects.antialias]\nsamples = 4\nadaptive = true\n")}) {
    CAPTURE(scene);
    testing::Setup setup = testing::front_view(8, 6, testing::scene_of(scene));
    setup.memory_bits = 512;
    setup.camera = {{-4, -20, 3}, {4, 2, -3}, view::Projection::perspective};
    const testing::Compiled compiled = testing::compile_text(models, setup);
    const story::StoryBuilder builder(compiled.program, testing::machine_of(compiled.program.shape));
    const story::Subject subject{compiled.program, nullptr};
    unsigned seen = 0;
    for (std::uint32_t y = 0; y < 6; ++y) {
      for (std::uint32_t x = 0; x < 8; ++x) {
        CAPTURE(x);
        CAPTURE(y);
        const nlohmann::json json = story::to_json(subject, builder.story_of(x, y));
        if (json["owner"].is_null()) continue;
        CHECK(seen_surface(json)["primitive"] == json["owner"]);
        ++seen;
      }
    }
    CHECK(seen >= 10);
  }
}

TEST_CASE("each event has the clocks in which the pixel executes its instruction") {
  const PixelCase pixel = draw_case(blind_hole + near_box, 3, 2);
  const story::Story story = pixel.story();
  const isa::Program& program = pixel.compiled.program;
  const machines::RunRecord record = functional::make_run_record(program, pixel.machine);
  const machines::Timeline timeline = machines::timeline(program, pixel.machine, record.outcome());
  const auto clocks = machines::spans_at_pixel(timeline, program, pixel.machine, 0, 3, 2);
  std::uint64_t last = 0;
  for (const story::Event& event : story.events) {
    if (event.kind == EventKind::skip) continue;
    CHECK(event.clocks.begin == clocks[event.first].begin);
    CHECK(event.clocks.end == clocks[event.last].end);
    CHECK(event.clocks.begin >= last);
    last = event.clocks.end;
  }
  CHECK(last > 0);
}

TEST_CASE("a run of one pixel equals that of the whole array with effects") {
  const std::string models = "union(){" + first + blind_hole + near_box + "color([0.2,0.5,0.9,0.4]){" +
                             box_text({0.5, 0.25, -3}, {6, 0.75, -1.5}) + "}}";
  testing::Setup setup = testing::front_view(
      8, 6,
      testing::scene_of("[effects.shadows]\n[effects.smooth]\n[effects.edges]\n[effects.antialias]\nsamples = 2\n"));
  setup.memory_bits = 512;
  const testing::Compiled compiled = testing::compile_text(models, setup);
  const isa::Program& program = compiled.program;
  const machines::Machine machine = testing::machine_of(program.shape);
  const observe::Frame frame = testing::draw(program);
  const std::vector<machines::Skip> skips = functional::make_run_record(program, machine).skips;
  for (std::uint32_t y = 0; y < 6; ++y) {
    for (std::uint32_t x = 0; x < 8; ++x) {
      const story::PixelRun run = story::run_pixel(program, skips, x, y);
      const std::size_t at = std::size_t{y} * 8 + x;
      CHECK(run.colour == frame.colour[at]);
      CHECK(run.nearest.depth == frame.depth[at]);
      CHECK(run.nearest.owner == frame.owner[at]);
      CHECK(run.opaque.depth == frame.opaque_depth[at]);
      CHECK(run.opaque.owner == frame.opaque_owner[at]);
    }
  }
}

TEST_CASE("a story's text names owner and line and plane and its JSON the owner and depth") {
  const PixelCase pixel = draw_case(big + near_box, 4, 2);
  const story::HalfspaceFinder finder(pixel.compiled.tree, pixel.compiled.scene, pixel.compiled.view);
  const story::Subject subject{pixel.compiled.program, &finder};
  const story::Story story = pixel.story();
  const std::string text = text_of(subject, story);
  CHECK(text.starts_with("pixel 4,2 shows p2 cube@3:56, line 3 of test\n  depth     209715 steps, "));
  CHECK(contains(text, "normal (0, -1, 0), distance -1\n"));
  CHECK(contains(text, "over p1 cube@2:56"));
  const nlohmann::ordered_json json = story::to_json(subject, story);
  CHECK(json["owner"]["index"] == 2);
  CHECK(json["owner"]["name"] == "cube@3:56");
  CHECK(json["depth"]["steps"] == at_1);
  CHECK(json["events"].size() == story.events.size());
  CHECK(json["surfaces"].back()["fate"] == "seen");
}

TEST_CASE("the first of several planes at one depth decides a pixel") {
  const story::Story left = by_hand("", 0);
  const story::Story right = by_hand("", 1);
  // i4 is 5 at x = 0, like i3, and 6 at x = 1.
  CHECK(left.attempts.front().fate == Fate::seen);
  CHECK(left.events[left.attempts.front().first_event].decision->number == 3);
  CHECK(left.depth == 5);
  CHECK(right.events[right.attempts.front().first_event].decision->number == 4);
  CHECK(right.depth == 6);
}

TEST_CASE("a run of one pixel skips the instructions that the whole array skips") {
  const std::string nowhere = "edge_negative 0 (w1); classify p0\n";
  const std::string right_alone = "edge_negative -x (w3); classify p0\n";
  const std::string query = "skip_if_none 2; classify p0\nenable_all; classify p0\nset_constant Z2, 7; classify p0\n";
  const story::Story skipped = by_hand(nowhere + query, 0);
  CHECK(skipped.depth == 5);
  const auto skip = std::find_if(skipped.events.begin(), skipped.events.end(),
                                 [](const story::Event& event) { return event.kind == EventKind::skip; });
  REQUIRE(skip != skipped.events.end());
  CHECK(skip->first == 9);
  CHECK(skip->last == 10);
  CHECK(skip->decision->number == 8);
  const story::Story carried_out = by_hand(right_alone + query, 0);
  CHECK(carried_out.depth == 7);
  CHECK(std::none_of(carried_out.events.begin(), carried_out.events.end(),
                     [](const story::Event& event) { return event.kind == EventKind::skip; }));
}

TEST_CASE("a story of a pixel outside the picture is rejected") {
  const PixelCase pixel = draw_case(big, 8, 2);
  CHECK(contains(testing::error_of([&] { static_cast<void>(pixel.story()); }),
                 "there is no pixel 8,2 in a picture of 8 x 6"));
}