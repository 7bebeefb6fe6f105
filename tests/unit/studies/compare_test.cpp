
#include <doctest/doctest.h>

#include <array>
#include <string>
#include <vector>

#include "host/read/read.h"
#include "hw/kinds/load.h"
#include "hw/machines/kind.h"
#include "sim/engine/engine.h"
#include "sim/observe/stats.h"
#include "sim/session/options/option_list.h"
#include "sim/studies/compare/measure.h"
#include "sim/studies/runner.h"
#include "tests/support/drawing.h"
#include "tests/unit/studies/study_rows.h"

using namespace csgsim;

namespace {

using Words = std::vector<std::string>;

const char* const bitten_cube = "difference(){cube(size=14,center=true);sphere($fn=24,$fa=12,$fs=2,r=9);}";

/// Points that a command requests, as the first cells of their rows.
Words requested_points(const Words& words) {
  session::OptionList list("compare");
  const auto command = studies::add_study_options(list, studies::compare_row);
  list.give_words(std::span(words).subspan(1));
  list.check_and_apply();
  Words points;
  for (const studies::PointRequest& one : command->study->request_points()) points.push_back(one.cells);
  return points;
}

}  // namespace

TEST_CASE("a point of compare has the counts of the Program's reference-level run") {
  const model::Tree tree = read::read_csg_text(bitten_cube, "test");
  studies::ComparisonJob job;
  job.point = {"pixel-planes-4", 24, 20, 0, {}};
  job.machine = kinds::load("pixel-planes-4");
  job.camera = {{40, -60, 45}, {0, 0, 0}};
  job.sampling.width = 24;
  job.sampling.height = 20;
  const studies::ComparisonRow row = studies::measure(job, tree);
  REQUIRE(row.reason.empty());
  machines::Machine machine = job.machine;
  machines::set_picture_size(machine, {24, 20});
  const facet::Geometry scene = facet::make_geometry(tree);
  const view::View view = view::make_view(scene, tree, job.camera, job.sampling);
  const isa::Program program = emit::compile(tree, scene, view, machine, {});
  observe::StatsObserver stats(program);
  const std::array<engine::Observer*, 1> observers{&stats};
  const engine::RunResult result = engine::make_reference_engine(machine)->run(program, observers);
  CHECK(row.processors == 24 * 20);
  CHECK(row.clocks == result.clocks);
  CHECK(row.enabled == stats.stats().total.enabled);
  CHECK(row.enabled > 0);
  const auto paid = static_cast<double>(24 * 20 * result.clocks);
  CHECK(row.utilisation == doctest::Approx(static_cast<double>(stats.stats().total.enabled) / paid));
  const auto hz = static_cast<double>(machine.clock_hz);
  CHECK(row.interval_clocks == result.interval_clocks);
  CHECK(row.host_clocks == result.host_clocks);
  CHECK(row.host_model_clocks == result.host_model_clocks);
  REQUIRE(result.host_clocks > result.interval_clocks);
  CHECK(row.hosted_frames_per_second * static_cast<double>(result.host_clocks) == doctest::Approx(hz));
  CHECK(row.frames_per_second * static_cast<double>(result.interval_clocks) == doctest::Approx(hz));
}

TEST_CASE("compare requests each point once even if a side equals the picture's") {
  const std::string model = testing::model_path("thesis_fig_2_3");
  const Words points = requested_points(
      {"compare", model, "--machines", "scan-line", "--size", "32x32", "--sides", "16,32", "--fragments", "5"});
  CHECK(points == Words{"scan-line,32,32,0,", "scan-line,32,32,5,", "scan-line,16,16,0,"});
}
