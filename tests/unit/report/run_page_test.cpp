#include "sim/report/run_page.h"

#include <doctest/doctest.h>

#include <array>
#include <string>

#include "sim/engine/engine.h"
#include "sim/observe/stats.h"
#include "sim/observe/stats_json.h"
#include "tests/support/drawing.h"

using namespace csgsim;
using report::Json;

TEST_CASE("a run's page shows the stats in words and the most expensive primitives") {
  testing::Setup setup;
  setup.camera.eye = {20, -30, 25};
  setup.camera.centre = {0, 0, 0};
  setup.sampling.width = 16;
  setup.sampling.height = 12;
  const isa::Program program = testing::compile_text("cube(size = [8, 8, 8], center = true);", setup).program;
  const machines::Machine machine = testing::machine_of(program.shape);
  observe::FrameObserver frame(program);
  observe::StatsObserver stats(program);
  const std::array<engine::Observer*, 2> observers{&frame, &stats};
  const engine::RunResult result = engine::make_functional_engine(machine)->run(program, observers);
  Json file = observe::to_json({program, machine, "functional", result, stats.stats(), 1.2345678});
  const auto page = [&] {
    return report::to_html(report::run_page(file, frame.frame(), program, machine, {"csgsim render m.csg", {}}));
  };
  const std::string plain = page();
  CHECK(plain.find("1.2345678") == std::string::npos);
  CHECK(plain.find("data-at=\"/by_primitive/0/clocks\"") != std::string::npos);
  CHECK(plain.find("<th scope=row>half-spaces</th><td class=n data-at=\"/model/halfspaces\">6<") != std::string::npos);
  CHECK(plain.find("wrong pixels") == std::string::npos);  // they have not been counted
  file["bound_by"] = {{"part", "controller"}, {"share", 0.9}, {"sentence", "The controller <bounds> it."}};
  file["accuracy"]["wrong"] = 3;
  file["knobs"] = {{{"sentence", "Turn this."}}};
  file["dearest"] = {{{"primitive", 0},
                      {"name", "cube@1:1"},
                      {"source", "1:1"},
                      {"clocks", 77},
                      {"share", 0.5},
                      {"pieces", 1},
                      {"halfspaces", 6}}};
  file["configuration"] = {{"view", {{"camera", "a b"}}}};
  const std::string html = page();
  for (const std::string part :
       {"The controller &lt;bounds&gt; it.", "Turn this.", "data-at=\"/dearest/0/halfspaces\">6<",
        "data-at=\"/configuration/view/camera\">a b<", "data-at=\"/accuracy/wrong\">3<"})
    CHECK(html.find(part) != std::string::npos);
}
