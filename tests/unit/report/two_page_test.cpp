#include "sim/report/two_page.h"

#include <doctest/doctest.h>

#include <array>
#include <string>

#include "sim/engine/engine.h"
#include "sim/observe/stats.h"
#include "sim/observe/stats_json.h"
#include "tests/support/drawing.h"

using namespace csgsim;

namespace {

struct Run {
  isa::Program program;
  machines::Machine machine;
  observe::Frame frame;
  report::Json stats;
};

Run draw_run(const std::string& text) {
  testing::Setup setup;
  setup.camera.eye = {20, -30, 25};
  setup.camera.centre = {0, 0, 0};
  setup.sampling.width = 16;
  setup.sampling.height = 12;
  const isa::Program program = testing::compile_text(text, setup).program;
  const machines::Machine machine = testing::machine_of(program.shape);
  observe::FrameObserver frame(program);
  observe::StatsObserver stats(program);
  const std::array<engine::Observer*, 2> observers{&frame, &stats};
  const engine::RunResult result = engine::make_functional_engine(machine)->run(program, observers);
  return {program, machine, std::move(frame).frame(),
          observe::to_json({program, machine, "functional", result, stats.stats(), 1.2345678})};
}

report::Page make_page(const Run& a, const Run& b) {
  const auto shown = [](const Run& run, const char* name) {
    return report::ShownRun{
        name, {run.program, run.frame}, run.machine, run.stats, std::string("csgsim explain ") + name};
  };
  return report::two_page(shown(a, "large"), shown(b, "small"), {{"They differ."}, 5}, {"csgsim diff a.csg b.csg", {}});
}

}  // namespace

TEST_CASE("two runs are shown with both counts and their ratio and the differing pixels") {
  const Run a = draw_run("cube(size = [8, 8, 8], center = true);");
  const Run b = draw_run("cube(size = [4, 4, 4], center = true);");
  const report::Page page = make_page(a, b);
  std::uint64_t differ = 0;
  std::size_t first = a.frame.colour.size();
  for (std::size_t i = a.frame.colour.size(); i-- > 0;) {
    if (a.frame.colour[i] == b.frame.colour[i] && a.frame.owner[i] == b.frame.owner[i]) continue;
    ++differ;
    first = i;
  }
  REQUIRE(differ > 0);
  CHECK(page.data["difference"]["pixels"] == differ);
  CHECK(page.data["difference"]["first"] == report::Json{first % 16, first / 16});
  const std::string html = report::to_html(page);
  CHECK(html.find("1.2345678") == std::string::npos);
  CHECK(html.find("<p>They differ.</p>") != std::string::npos);
  for (const std::string at : {"/a/clocks", "/b/clocks", "/a/by_purpose/render/clocks", "/b/by_purpose/merge/clocks"})
    CHECK(html.find("data-at=\"" + at + "\"") != std::string::npos);
  for (const std::string box :
       {"data-of=\"drawing-0\"", "data-of=\"drawing-1\"", "id=\"drawing-0\"", "id=\"drawing-1\""})
    CHECK(html.find(box) != std::string::npos);
  CHECK(html.find(std::to_string(differ) + " pixels differ between A and B") != std::string::npos);
  for (const std::size_t section : {3U, 4U}) {
    const auto& drawing = std::get<report::Drawing>(page.sections[section].parts[0]);
    CHECK(drawing.explain == (section == 3 ? "csgsim explain large" : "csgsim explain small"));
    REQUIRE(drawing.stories.size() >= 3);
    CHECK(drawing.stories[0].y * 16 + drawing.stories[0].x == 5);
    CHECK(drawing.stories[1].y * 16 + drawing.stories[1].x == first);
    const std::size_t third = drawing.stories[2].y * 16 + drawing.stories[2].x;
    CHECK(a.frame.colour[third] != b.frame.colour[third]);
  }
}

TEST_CASE("a run does not differ from itself in any pixel") {
  const Run a = draw_run("cube(size = [8, 8, 8], center = true);");
  const report::Page page = make_page(a, a);
  CHECK(page.data["difference"]["pixels"] == 0);
  CHECK(page.data["difference"]["first"].is_null());
}
