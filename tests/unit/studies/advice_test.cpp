#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "host/emit/compile.h"
#include "host/read/read.h"
#include "hw/base/error.h"
#include "hw/kinds/load.h"
#include "sim/engine/engine.h"
#include "sim/observe/frame.h"
#include "sim/studies/accuracy/measure.h"
#include "sim/studies/advise/options.h"
#include "sim/studies/advise/show.h"
#include "sim/studies/design/axes.h"
#include "sim/studies/design/grid.h"
#include "sim/studies/design/meter.h"
#include "sim/studies/fitted_program.h"
#include "sim/studies/parallel.h"
#include "sim/studies/table.h"

using namespace csgsim;
using studies::AdviceRow;
using studies::DesignPoint;
using studies::Requirement;

namespace {

using Rows = std::vector<AdviceRow>;

const char* const bitten_cube =
    "difference(){cube(size=14,center=true);sphere($fn=24,$fa=12,$fs=2,r=9);"
    "intersection(){cube(size=10,center=false);sphere($fn=12,$fa=12,$fs=2,r=8);}}";
constexpr unsigned side = 40;

DesignPoint point_of_bits(unsigned z_bits, unsigned fraction_bits, unsigned colour_bits, const std::string& colouring,
                          const std::string& strategy, unsigned stack_bits, unsigned alu_bits) {
  return {.z_bits = z_bits,
          .fraction_bits = fraction_bits,
          .colour_bits = colour_bits,
          .colouring = colouring,
          .strategy = strategy,
          .stack_bits = stack_bits,
          .alu_bits = alu_bits};
}

AdviceRow row(std::uint32_t bits, std::uint64_t wrong, std::uint64_t interval, unsigned colour_bits = 24,
              unsigned alu_bits = 1) {
  AdviceRow one;
  one.point = point_of_bits(16, 6, colour_bits, "rebroadcast", "stack", 0, alu_bits);
  one.used_bits = bits;
  one.wrong = wrong;
  one.interval_clocks = interval;
  one.clocks = interval / 2;
  one.frames_per_second = 1e7 / static_cast<double>(interval);
  return one;
}

/// Two or more values on each axis, with ALU widths grouped.
std::vector<DesignPoint> small_points() {
  std::vector<DesignPoint> points;
  const studies::DesignGrid grid({}, {{"z-bits", {"12", "16"}},
                                      {"fraction-bits", {"2", "6"}},
                                      {"colour-bits", {"24", "12"}},
                                      {"colouring", {"rebroadcast", "field"}},
                                      {"strategy", {"stack", "list", "bits"}},
                                      {"stack-bits", {"3", "5"}}});
  for (const session::ModelRequest& design : grid.designs()) {
    for (const unsigned alu_bits : {1U, 4U}) {
      points.push_back(studies::point_of(design, {side, side}));
      points.back().machine.clear();
      points.back().alu_bits = alu_bits;
    }
  }
  return points;
}

/// Jobs by the ALU width of their machine.
struct AdviceJobs {
  std::map<unsigned, studies::Job> jobs;

  explicit AdviceJobs(const std::vector<std::string>& machines, const emit::Options& options = {},
                      const std::string& model = bitten_cube) {
    model::Tree tree = read::read_csg_text(model, "test");
    facet::Geometry scene = facet::make_geometry(tree);
    const auto subject =
        std::make_shared<studies::Subject>(studies::Subject{std::move(tree), std::move(scene), "hash"});
    for (const std::string& name : machines) {
      machines::Machine machine = kinds::load(name);
      machines::set_picture_size(machine, {side, side});
      studies::Job& job = jobs[machine.alu_bits];
      job = {subject, {{40, -60, 45}, {0, 0, 0}}, {}, std::move(machine), options, {}};
      job.sampling.width = job.sampling.height = side;
    }
  }

  [[nodiscard]] const studies::Job& front() const { return jobs.begin()->second; }
  [[nodiscard]] studies::Job at(const DesignPoint& point) const;
};

template <class Choices>
auto named(const Choices& choices, const std::string& name) {
  return *std::find_if(choices.begin(), choices.end(), [&](auto choice) { return emit::name_of(choice) == name; });
}

studies::Job AdviceJobs::at(const DesignPoint& point) const {
  studies::Job job = jobs.at(point.alu_bits);
  job.sampling.z_bits = point.z_bits;
  job.sampling.fraction_bits = point.fraction_bits;
  job.options.strategy = named(emit::strategies, point.strategy);
  job.options.stack_bits = std::max(point.stack_bits, emit::min_stack_bits);
  job.options.colouring = named(emit::colourings, point.colouring);
  job.options.colour_bits = point.colour_bits;
  return job;
}

Rows measured(const AdviceJobs& choices, const std::vector<DesignPoint>& points, unsigned threads) {
  studies::DesignMeter meter({.colour_bits = {24, 12}});
  Rows rows;
  studies::measure_each(
      points.size(), threads, [&](std::size_t i) { return meter.measure(points[i], choices.at(points[i])); },
      [&](studies::DesignRow one) { rows.emplace_back(std::move(one)); });
  std::ranges::sort(rows, {}, &AdviceRow::point);
  return rows;
}

/// Measures the point alone, as a recommended design is redrawn.
AdviceRow drawn(const AdviceJobs& choices, const DesignPoint& point) {
  return AdviceRow(studies::DesignMeter({.colour_bits = {point.colour_bits}}).measure(point, choices.at(point)));
}

/// Measures the point as csgsim sweep does.
studies::SweepRow swept(const AdviceJobs& choices, const DesignPoint& point, std::uint32_t memory_bits) {
  studies::Job job = choices.at(point);
  job.machine.array.memory_bits = memory_bits;
  return studies::SweepRow(measure_picture({}, job, true));
}

/// Wrong pixels as counted by csgsim accuracy.
std::uint64_t judged(const AdviceJobs& choices, const DesignPoint& point) {
  const studies::Job job = choices.at(point);
  studies::Meter meter(job.subject->tree, {job.camera}, job.machine, choices.front().options);
  return meter.measure({"together", "", {}, job.sampling}).wrong;
}

/// Whether the first is at least as good in every respect.
bool beats_or_equals(const AdviceRow& a, const AdviceRow& b) {
  const bool is_as_fast =
      a.interval_clocks < b.interval_clocks || (a.interval_clocks == b.interval_clocks && a.clocks <= b.clocks);
  return a.used_bits <= b.used_bits && a.wrong <= b.wrong && is_as_fast && a.point.colour_bits >= b.point.colour_bits &&
         a.point.alu_bits <= b.point.alu_bits;
}

const Requirement every_wish[] = {Requirement::bits, Requirement::wrong_pixels, Requirement::speed,
                                  Requirement::colour};

}  // namespace

TEST_CASE("advice tries each combination once and those that differ in ALU width in a row") {
  const std::vector<DesignPoint> points = small_points();
  CHECK(points.size() == 2 * 2 * 2 * 2 * 4 * 2);
  CHECK(studies::point_cells<AdviceRow>(points[0]) == "12,2,24,rebroadcast,stack,0,1");
  CHECK(studies::point_cells<AdviceRow>(points[1]) == "12,2,24,rebroadcast,stack,0,4");
  CHECK(studies::point_cells<AdviceRow>(points[4]) == "12,2,24,rebroadcast,bits,3,1");
  CHECK(studies::strategy_name(points[6]) == "bits 5");
  std::vector<DesignPoint> sorted = points;
  std::sort(sorted.begin(), sorted.end());
  CHECK(std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end());
}

TEST_CASE("advise's front has each unbeaten choice once") {
  const Rows rows{row(66, 0, 100),    row(62, 9, 100), row(66, 0, 100), row(66, 0, 90, 24, 2),
                  row(54, 0, 95, 12), row(66, 1, 100), row(70, 0, 110), row(62, 9, 100, 12)};
  const Rows front = studies::advice_front(rows);
  CHECK(front == Rows{row(54, 0, 95, 12), row(62, 9, 100), row(66, 0, 100), row(66, 0, 90, 24, 2)});
}

TEST_CASE("a choice without a Program is neither on the front nor recommended") {
  AdviceRow refused = row(0, 0, 1);
  refused.reason = "it does not fit";
  const studies::Requirements requirements{72, 10, 0, 24};
  const Rows rows{refused, row(66, 0, 100)};
  CHECK(studies::advice_front(rows) == Rows{rows[1]});
  for (const studies::Recommendation& one : studies::recommend(rows, requirements)) CHECK(one.row == rows[1]);
  CHECK(studies::nearest_choices(rows, requirements, 9) == Rows{rows[1]});
}

TEST_CASE("each recommendation is the best in one limit of the rows that meet the others") {
  // 1e7 / 400,000 is 25 frames a second.
  const studies::Requirements requirements{64, 10, 25, 24};
  const Rows rows{row(60, 8, 390'000), row(64, 2, 400'000), row(64, 9, 300'000),    row(58, 11, 390'000),
                  row(58, 5, 410'000), row(72, 0, 200'000), row(64, 0, 390'000, 18)};
  const std::vector<studies::Recommendation> all = studies::recommend(rows, requirements);
  REQUIRE(all.size() == 4);
  CHECK(all[0].requirement == Requirement::bits);
  CHECK(all[0].row == rows[0]);
  CHECK(all[1].row == rows[1]);
  CHECK(all[2].row == rows[2]);
  CHECK(all[3].row == rows[0]);
  for (const studies::Recommendation& one : all) CHECK(one.miss == 0);
}

TEST_CASE("a recommendation states the shortfall if no choice meets all limits") {
  const Rows rows{row(70, 3, 300'000), row(64, 30, 300'000), row(60, 3, 500'000), row(50, 500, 600'000, 3)};
  const studies::Requirements requirements{64, 10, 25, 24};
  const std::vector<studies::Recommendation> all = studies::recommend(rows, requirements);
  REQUIRE(all.size() == 3);
  CHECK(all[0].row == rows[0]);
  CHECK(all[0].miss == 6);
  CHECK(all[1].row == rows[1]);
  CHECK(all[1].miss == 20);
  CHECK(all[2].row == rows[2]);
  CHECK(all[2].miss == doctest::Approx(5));
  // 6 of 64 bits are a smaller fraction than 20 of 10 pixels and 5 of 25 frames.
  CHECK(studies::nearest_choices(rows, requirements, 2) == Rows{rows[0], rows[2]});
  CHECK(std::none_of(rows.begin(), rows.end(),
                     [&](const AdviceRow& one) { return studies::meets_all(one, requirements); }));
}

TEST_CASE("the nearest choices weigh both shortfalls if no wrong pixels are allowed") {
  const studies::Requirements requirements{60, 0, 0, 0};
  // 1 pixel and 6 of 60 bits are nearer than 3 pixels and 1 of 60 bits, though more bits are more expensive.
  const Rows rows{row(61, 3, 100), row(66, 1, 100)};
  CHECK(studies::nearest_choices(rows, requirements, 2) == Rows{rows[1], rows[0]});
}

TEST_CASE("advice agrees with sweep and accuracy and an exhaustive search on a grid") {
  const AdviceJobs job({"pixel-planes-4", "pixel-planes-4+alu.bits=4"});
  const std::vector<DesignPoint> points = small_points();
  const Rows rows = measured(job, points, 2);
  REQUIRE(rows.size() == points.size());
  for (const AdviceRow& one : rows) {
    CAPTURE(one.point.z_bits);
    CAPTURE(studies::strategy_name(one.point));
    REQUIRE(one.reason.empty());
    const studies::SweepRow other = swept(job, one.point, one.used_bits);
    CHECK(other.used_bits == one.used_bits);
    CHECK(other.classification_bits == one.classification_bits);
    CHECK(other.clocks == one.clocks);
    CHECK(swept(job, one.point, one.used_bits - 1).reason.find("memory bits") != std::string::npos);
    CHECK(judged(job, one.point) == one.wrong);
    CHECK((one.colour_error == 0) == (one.point.colour_bits == 24));
  }
  Rows front;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    bool is_dominated = false;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const bool is_same = beats_or_equals(rows[i], rows[k]);
      is_dominated = is_dominated || (k != i && beats_or_equals(rows[k], rows[i]) && (!is_same || k < i));
    }
    if (!is_dominated) front.push_back(rows[i]);
  }
  const Rows answer = studies::advice_front(rows);
  CHECK(answer.size() == front.size());
  for (const AdviceRow& one : front) CHECK(std::find(answer.begin(), answer.end(), one) != answer.end());
  CHECK(front.size() > 4);
  const studies::Requirements requirements{static_cast<std::uint32_t>(front[front.size() / 2].used_bits),
                                           front[front.size() / 2].wrong, front[front.size() / 2].frames_per_second,
                                           12};
  for (const studies::Recommendation& one : studies::recommend(rows, requirements)) {
    for (const AdviceRow& other : rows) {
      const bool is_eligible = std::all_of(std::begin(every_wish), std::end(every_wish), [&](Requirement requirement) {
        return requirement == one.requirement || studies::miss(other, requirement, requirements) == 0;
      });
      if (!is_eligible) continue;
      if (one.requirement == Requirement::bits) CHECK(one.row.used_bits <= other.used_bits);
      if (one.requirement == Requirement::wrong_pixels) CHECK(one.row.wrong <= other.wrong);
      if (one.requirement == Requirement::speed) CHECK(one.row.frames_per_second >= other.frames_per_second);
      if (one.requirement == Requirement::colour) CHECK(one.row.point.colour_bits >= other.point.colour_bits);
    }
    CHECK(one.miss == 0);
  }
}

TEST_CASE("the plot of advice has a staircase per useful wrong-pixel limit") {
  const Rows rows{row(72, 0, 50'000), row(64, 7, 50'000), row(80, 0, 25'000), row(90, 3, 20'000), row(70, 800, 10'000)};
  const studies::Requirements requirements{
      .max_bits = 80, .max_wrong_pixels = 5, .min_fps = 300, .min_colour_bits = 12};
  const plots::Plot plot = studies::plot_of_advice(rows, requirements, {}, "m.csg");
  const auto& chart = std::get<plots::Chart>(plot.content);
  const auto steps = [&](std::size_t series) {
    std::vector<std::pair<double, double>> points;
    for (const plots::Point& point : chart.series.at(series).points) points.emplace_back(point.x, point.y);
    return points;
  };
  REQUIRE(chart.series.size() == 5);  // the last two are the limits of bits and of frames
  CHECK(chart.series[0].name == "no wrong pixel");
  CHECK(steps(0) == std::vector<std::pair<double, double>>{{72, 200}, {80, 400}});
  CHECK(chart.series[1].name == "at most 5 wrong pixels");
  CHECK(steps(1) == std::vector<std::pair<double, double>>{{72, 200}, {80, 400}, {90, 500}});
  CHECK(chart.series[2].name == "at most 50 wrong pixels");
  CHECK(steps(2) == std::vector<std::pair<double, double>>{{64, 200}, {80, 400}, {90, 500}});
}

TEST_CASE("advice depends neither on the number of threads nor on the grouping of points") {
  const AdviceJobs job({"pixel-planes-4", "pixel-planes-4+alu.bits=4"});
  const std::vector<DesignPoint> points = small_points();
  const Rows rows = measured(job, points, 1);
  CHECK(measured(job, points, 3) == rows);
  for (std::size_t i = 0; i < rows.size(); i += 7) CHECK(drawn(job, rows[i].point) == rows[i]);
}

TEST_CASE("the memory of a second frame buffer counts among a choice's bits") {
  const DesignPoint point = point_of_bits(16, 6, 24, "rebroadcast", "stack", 0, 1);
  const AdviceRow one = drawn(AdviceJobs({"pixel-planes-4"}), point);
  const AdviceRow two = drawn(AdviceJobs({"pixel-planes-4+scan_out.buffers=2"}), point);
  CHECK(two.used_bits == one.used_bits + 24);
}

TEST_CASE("the colour error of a choice is found in any channel and is at most half a step") {
  emit::Options before_black;
  before_black.scene.background.colour = {0, 0, 0};
  for (const char* const colour : {"0.9,0,0", "0,0.9,0", "0,0,0.9"}) {
    CAPTURE(colour);
    const std::string model = std::string("color([") + colour + ",1]){cube(size=14,center=true);}";
    const AdviceJobs job({"pixel-planes-4"}, before_black, model);
    CHECK(drawn(job, point_of_bits(16, 6, 24, "rebroadcast", "stack", 0, 1)).colour_error == 0);
    // With 12 bits a channel has 4, whose levels are 17 of 255 apart.
    const AdviceRow row = drawn(job, point_of_bits(16, 6, 12, "rebroadcast", "stack", 0, 1));
    CHECK(row.colour_error > 0);
    CHECK(row.colour_error <= 8);
  }
}

TEST_CASE("a choice that exceeds the memory limit has a row with the reason") {
  const std::string many = [] {
    std::string text = "intersection(){cube(size=14,center=true);union(){";
    for (int i = 0; i < 600; ++i)
      text += "multmatrix([[1,0,0," + std::to_string(i % 20 - 10) + "],[0,1,0," + std::to_string(i / 20 - 15) +
              "],[0,0,1,7],[0,0,0,1]]){difference(){cube(size=1,center=true);sphere($fn=8,$fa=12,$fs=2,r=0.6);}}";
    return text + "}}";
  }();
  emit::Options unpruned;
  unpruned.pruning = {.space = false, .picture = false, .separation = false};
  const AdviceJobs job({"pixel-planes-4"}, unpruned, many);
  const AdviceRow refused = drawn(job, point_of_bits(16, 6, 24, "rebroadcast", "parallel", 0, 1));
  CHECK(refused.reason.find("memory bits") != std::string::npos);
  CHECK(drawn(job, point_of_bits(16, 6, 24, "rebroadcast", "list", 0, 1)).is_compiled());
}

TEST_CASE("fitting a Program to its memory does not depend on the first guess") {
  const AdviceJobs job({"pixel-planes-4"});
  const view::View view =
      view::make_view(job.front().subject->scene, job.front().subject->tree, job.front().camera, job.front().sampling);
  const auto fitted = [&](std::uint32_t likely) {
    return studies::compile_with_least_memory(job.front().subject->tree, job.front().subject->scene, view,
                                              job.front().machine, job.front().options, {likely, 256});
  };
  const studies::FittedProgram plain = fitted(0);
  const std::uint32_t bits = plain.machine.array.memory_bits;
  CHECK(plain.program.shape.memory_bits == bits);
  for (const std::uint32_t likely : {bits - 3, bits, bits + 5, 300U}) {
    const studies::FittedProgram other = fitted(likely);
    CHECK(other.machine.array.memory_bits == bits);
    CHECK(other.program.segments == plain.program.segments);
  }
  CHECK_THROWS_AS(studies::compile_with_least_memory(job.front().subject->tree, job.front().subject->scene, view,
                                                     job.front().machine, job.front().options, {0, bits - 1}),
                  InputError);
}

TEST_CASE("a timer that runs a Program once has the clocks of separate runs per machine") {
  const AdviceJobs job({"pixel-planes-4"});
  const view::View view =
      view::make_view(job.front().subject->scene, job.front().subject->tree, job.front().camera, job.front().sampling);
  studies::RunTimer timer;
  bool skips = false;
  for (const char* name : {"pixel-planes-4", "pixel-planes-4+alu.bits=2", "pixel-planes-4+link.width=16"}) {
    machines::Machine machine = kinds::load(name);
    machines::set_picture_size(machine, {side, side});
    const isa::Program program =
        emit::compile(job.front().subject->tree, job.front().subject->scene, view, machine, job.front().options);
    const engine::RunResult result = engine::make_functional_engine(machine)->run(program, {});
    skips = skips || result.skipped > 0;
    const machines::FrameTiming timing = timer.time(program, machine);
    CHECK(timing.clocks == result.clocks);
    CHECK(timing.interval_clocks == result.interval_clocks);
  }
  CHECK(skips);
}

TEST_CASE("a row of advise survives a round trip through its table") {
  AdviceRow one = row(66, 3, 411'000, 18, 4);
  one.inputs = {"0123456789abcdef", "fedcba9876543210", "0.1.0"};
  one.colour_error = 2;
  CHECK(studies::from_line<AdviceRow>(studies::to_line(one)) == one);
}