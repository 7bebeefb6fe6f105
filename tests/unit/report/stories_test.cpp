#include "sim/report/stories.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "hw/kinds/load.h"
#include "sim/observe/frame.h"
#include "sim/report/parts_html.h"
#include "sim/story/story.h"
#include "sim/story/story_text.h"
#include "tests/unit/report/bitten_cube.h"

using namespace csgsim;

namespace {

/// Middle pixels of the rows of the bitten cube's picture.
std::vector<std::size_t> pixels_in(const isa::Program& program) {
  std::vector<std::size_t> pixels;
  for (std::size_t row = 0; row < program.shape.height; ++row)
    pixels.push_back(row * program.shape.width + program.shape.width / 2);
  return pixels;
}

std::string text_in(const report::Json& parts) {
  std::string text;
  for (const report::Json& part : parts) text += (part.is_array() ? part[0] : part).get<std::string>();
  return text;
}

std::size_t bytes_of(const report::Drawing& drawing) {
  std::size_t bytes = 0;
  for (const report::PixelStory& story : drawing.stories)
    for (const story::TextPart& part : story.parts) bytes += part.text.size();
  return bytes;
}

}  // namespace

TEST_CASE("the pixel explained for an owner is farthest from other owners and the border") {
  constexpr std::uint32_t none = observe::no_owner;
  const std::vector<std::uint32_t> owner{
      none, 7, 7, 7, 7,     //
      none, 7, 7, 7, none,  //
      none, 7, 7, 7, 3,     //
      none, 7, 7, 7, 3,     //
      none, 7, 7, 7, 3,
  };
  CHECK(report::central_pixels(owner, 5, std::vector<std::uint32_t>{3, 4, 7, none}) ==
        std::vector<std::size_t>{19, 12, 10});
}

TEST_CASE("a page contains the text of csgsim explain and the first step after each event") {
  for (const std::string machine_name : {"", "pixel-planes-5"}) {
    CAPTURE(machine_name);
    const isa::Program program = testing::bitten_cube(machine_name).program;
    const machines::Machine machine =
        machine_name.empty() ? testing::machine_of(program.shape) : kinds::load(machine_name);
    report::Drawing drawing = report::record_drawing(program, machine, {.instructions = 10});
    report::add_stories({program}, machine, pixels_in(program), drawing);
    REQUIRE(drawing.stories.size() == program.shape.height);
    CHECK(drawing.summary.ends_with("Pixels with a history on this page: 30."));
    const story::StoryBuilder builder(program, machine);
    const report::Json json = report::drawing_json(drawing)["stories"];
    std::size_t events = 0;
    for (std::size_t i = 0; i < json.size(); ++i) {
      const story::Story story = builder.story_of(json[i]["x"], json[i]["y"]);
      CHECK(json[i]["y"] == i);
      CHECK(json[i]["primitive"].is_null() == (story.owner == observe::no_owner));
      CHECK(text_in(json[i]["parts"]) == story::text_of({program}, story));
      for (std::size_t part = 0; part < json[i]["parts"].size(); ++part) {
        const report::Json& event = json[i]["parts"][part];
        REQUIRE(event.is_array() == (drawing.stories[i].parts[part].end > 0));
        if (!event.is_array()) continue;
        ++events;
        const std::size_t step = event[1];
        REQUIRE(step > 0);
        CHECK(drawing.steps.at(step).number >= drawing.stories[i].parts[part].end);
        CHECK(drawing.steps[step - 1].number < drawing.stories[i].parts[part].end);
      }
    }
    CHECK(events > 100);
  }
}

TEST_CASE("a page has one explanation per pixel within limits on length and number") {
  const isa::Program program = testing::bitten_cube().program;
  const machines::Machine machine = testing::machine_of(program.shape);
  const report::Drawing drawing = report::record_drawing(program, machine);
  const std::vector<std::size_t> pixels = pixels_in(program);
  const auto with_limits = [&](const std::vector<std::size_t>& requested, const report::StoryLimits& limits) {
    report::Drawing with_stories = drawing;
    report::add_stories({program}, machine, requested, with_stories, limits);
    return with_stories;
  };
  CHECK(with_limits({5, 5, 6, 5}, {}).stories.size() == 2);
  CHECK(with_limits(pixels, {.pixels = 3}).stories.size() == 3);
  const std::uint64_t count = program.segments.front().instructions.size();
  CHECK(with_limits(pixels, {.instructions = 4 * count}).stories.size() == 4);
  for (const std::size_t most : {std::size_t{5'000}, std::size_t{20'000}}) {
    const report::Drawing some = with_limits(pixels, {.bytes = most});
    const report::Drawing one_more = with_limits(pixels, {.pixels = some.stories.size() + 1});
    CHECK(bytes_of(some) <= most);
    CHECK(bytes_of(one_more) > most);
  }
  CHECK(with_limits(pixels, {.bytes = 0}).stories.size() == 1);
}
