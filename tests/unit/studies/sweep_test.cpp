
#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "host/read/read.h"
#include "hw/base/error.h"
#include "hw/base/hash.h"
#include "hw/kinds/load.h"
#include "hw/machines/area.h"
#include "sim/session/options/lists.h"
#include "sim/session/options/option_list.h"
#include "sim/studies/design/grid.h"
#include "sim/studies/design/meter.h"
#include "sim/studies/parallel.h"
#include "sim/studies/row_text.h"
#include "sim/studies/runner.h"
#include "sim/studies/sweep/show.h"
#include "tests/support/drawing.h"
#include "tests/unit/studies/study_rows.h"

using namespace csgsim;

namespace {

using Numbers = std::vector<unsigned>;
using Words = std::vector<std::string>;

std::vector<studies::DesignPoint> small_points() {
  std::vector<studies::DesignPoint> points;
  for (const char* const model : {"a.csg", "b.csg"}) {
    session::ModelRequest base;
    base.model = model;
    const studies::DesignGrid grid(
        base, {{"z-bits", {"16", "20"}}, {"strategy", {"stack", "bits"}}, {"stack-bits", {"3", "5"}}});
    for (const session::ModelRequest& design : grid.designs()) points.push_back(studies::point_of(design, {48, 36}));
  }
  return points;
}

studies::SweepRow row_of(const studies::DesignPoint& point, const std::string& picture) {
  studies::SweepRow row;
  row.point = point;
  row.inputs = {"0123456789abcdef", "fedcba9876543210", "0.1.0"};
  row.picture = picture;
  if (point.strategy == "bits") row.pixel_transistors = 650;
  return row;
}

const char* const bitten_cube = "difference(){cube(size=14,center=true);sphere($fn=24,$fa=12,$fs=2,r=9);}";

/// A point with its job.
struct Drawn {
  studies::DesignPoint point;
  studies::Job job;
};

/// Points of one model with strategies that all fit.
std::vector<Drawn> drawn_points() {
  model::Tree tree = read::read_csg_text(bitten_cube, "test");
  facet::Geometry scene = facet::make_geometry(tree);
  const auto subject = std::make_shared<studies::Subject>(studies::Subject{std::move(tree), std::move(scene), "hash"});
  machines::Machine machine = kinds::load("pixel-planes-4");
  machine.array.width = machine.array.height = 40;
  view::Sampling sampling;
  sampling.width = sampling.height = 40;
  std::vector<Drawn> all;
  for (const emit::Strategy strategy : {emit::Strategy::stack, emit::Strategy::list, emit::Strategy::bits}) {
    Drawn one{{}, {subject, {{40, -60, 45}, {0, 0, 0}}, sampling, machine, {}, {}}};
    one.point.strategy = emit::name_of(strategy);
    one.job.options.strategy = strategy;
    all.push_back(std::move(one));
  }
  return all;
}

studies::SweepRow measured(const Drawn& one, bool is_drawn) {
  return studies::SweepRow(measure_picture(one.point, one.job, is_drawn));
}

}  // namespace

TEST_CASE("a list of numbers may have ranges and keeps its order without repetitions") {
  CHECK(session::parse_numbers("7", 3, 9) == Numbers{7});
  CHECK(session::parse_numbers("3..6", 3, 9) == Numbers{3, 4, 5, 6});
  CHECK(session::parse_numbers("9,3,5", 3, 9) == Numbers{9, 3, 5});
  CHECK(session::parse_numbers("3..5,4..6,3", 3, 9) == Numbers{3, 4, 5, 6});
  CHECK(session::parse_numbers("8..8", 3, 9) == Numbers{8});
}

TEST_CASE("a text that is not a list of numbers is rejected") {
  for (const char* const text :
       {"", ",", "3,", "3..", "..3", "3...5", "a", "3-5", "3..x", "-3", "3 ", "8..3", "2..5", "3..10", "99999999999"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(session::parse_numbers(text, 3, 9), InputError);
  }
}

TEST_CASE("an unknown name in a list is rejected with a similar one") {
  const Words known{"stack", "list", "bits"};
  CHECK(session::parse_names("list,stack,list", "strategy", known) == Words{"list", "stack"});
  CHECK_THROWS_WITH_AS(session::parse_names("stack,lst", "strategy", known),
                       "there is no strategy 'lst'; did you mean list? The strategies are stack, list, bits",
                       InputError);
  CHECK_THROWS_WITH_AS(session::parse_names("quixotic", "level", known),
                       "there is no level 'quixotic'; the levels are stack, list, bits", InputError);
  CHECK_THROWS_AS(session::parse_names("", "level", known), InputError);
}

TEST_CASE("a sweep has a point per combination and varies only stack bits that matter") {
  const std::vector<studies::DesignPoint> points = small_points();
  REQUIRE(points.size() == 2 * 2 * 3);
  CHECK(studies::point_cells<studies::SweepRow>(points[0]) == "a.csg,pixel-planes-4,,16,auto,rebroadcast,stack,0,auto");
  CHECK(studies::point_cells<studies::SweepRow>(points[1]) == "a.csg,pixel-planes-4,,16,auto,rebroadcast,bits,3,auto");
  CHECK(points[2].stack_bits == 5);
  CHECK(points[3].z_bits == 20);
  CHECK(points[6].model == "b.csg");
  for (std::size_t i = 0; i < points.size(); ++i) CHECK(std::count(points.begin(), points.end(), points[i]) == 1);
}

TEST_CASE("a sweep's row survives a round trip through its table with commas and quotes") {
  studies::SweepRow row = row_of(small_points()[1], "");
  row.point.model = "a \"model\", of mine.csg";
  row.point.fraction_bits = row.point.colour_bits = 0;  // not columns of a sweep
  row.reason = "needs 90 bits, has 72; take \"list\"";
  row.memory_map = {{"Z2", 0, 20}, {"stack", 65, 3}};
  row.simulated_seconds = 0.1;
  CHECK(studies::from_line<studies::SweepRow>(studies::to_line(row)) == row);
  CHECK_THROWS_AS(studies::to_cell(std::string("two\nlines")), InputError);
}

TEST_CASE("a sweep's measured row survives a round trip through its table with all counts") {
  const std::vector<Drawn> all = drawn_points();
  const studies::SweepRow row = measured(all.front(), true);
  CHECK(row.rendered > 0);
  CHECK(row.classified > 0);
  CHECK(row.depth_tests > 0);
  CHECK(studies::from_line<studies::SweepRow>(studies::to_line(row)) == row);
}

TEST_CASE("a memory map with commas and quotes survives a round trip through a table") {
  studies::SweepRow row;
  row.memory_map = {{"a,b", 0, 20}, {"\"c\"", 20, 1}};
  const std::string line = studies::to_line(row);
  CHECK(studies::from_line<studies::SweepRow>(line) == row);
}

TEST_CASE("a table line that an editor ended with CR LF is rejected") {
  const std::string line = studies::to_line(row_of(small_points()[1], "")) + "\r";
  CHECK_THROWS_WITH_AS(studies::from_line<studies::SweepRow>(line),
                       "the line contains a line break, perhaps from an editor that ends lines with CR LF", InputError);
}

TEST_CASE("the name of a point lists only the parameters that vary") {
  std::vector<studies::SweepRow> rows;
  for (const studies::DesignPoint& point : small_points()) rows.push_back(row_of(point, ""));
  rows.resize(6);  // only those of the first model
  const studies::PointNames names(rows);
  CHECK(names.name(rows[0].point) == "stack, z 16");
  CHECK(names.name(rows[5].point) == "bits 5, z 20");
  CHECK(studies::group_by_conditions(rows).size() == 2);
  CHECK(studies::PointNames(std::span(rows).first(3)).conditions(rows[0].point).empty());
}

TEST_CASE("a sweep reports pictures that differ from others of equal model and z bits") {
  std::vector<studies::SweepRow> rows;
  for (const studies::DesignPoint& point : small_points())
    rows.push_back(row_of(point, point.model + std::to_string(point.z_bits)));
  CHECK(studies::wrong_pictures(rows).empty());
  rows[4].picture = "another";
  rows[7].picture = "";
  rows[9].picture = studies::overflow;
  const std::vector<studies::WrongPicture> wrong = studies::wrong_pictures(rows);
  REQUIRE(wrong.size() == 2);
  CHECK(wrong[0].reference == rows[3].point);
  CHECK(wrong[0].point == rows[4].point);
  CHECK(!wrong[1].reference);
  CHECK(wrong[1].point == rows[9].point);
}

TEST_CASE("a sweep's points measured in parallel equal those measured one by one") {
  const std::vector<Drawn> all = drawn_points();
  std::vector<studies::SweepRow> rows;
  studies::measure_each(
      all.size(), 3, [&](std::size_t i) { return measured(all[i], true); },
      [&](studies::SweepRow row) { rows.push_back(std::move(row)); });
  REQUIRE(rows.size() == all.size());
  for (const Drawn& one : all) {
    const studies::SweepRow expected = measured(one, true);
    CHECK(expected.is_compiled());
    CHECK(expected.clocks > 100);
    CHECK(expected.pixel_transistors == machines::pixel_transistors(one.job.machine, expected.used_bits));
    CHECK(expected.pixel_transistors < machines::pixel_transistors(one.job.machine, 256));
    CHECK(expected.picture == rows.front().picture);
    CHECK(std::count(rows.begin(), rows.end(), expected) == 1);
  }
  CHECK(measured(all.front(), false).picture.empty());
}

TEST_CASE("the colour of a second buffer counts once in a pixel's transistors") {
  Drawn point = drawn_points().front();
  const studies::SweepRow one = measured(point, false);
  point.job.machine = kinds::load("pixel-planes-4+scan_out.buffers=2+array.memory_bits=128");
  point.job.machine.array.width = point.job.machine.array.height = 40;
  const studies::SweepRow two = measured(point, false);
  CHECK(two.used_bits == one.used_bits + 24);
  CHECK(two.pixel_transistors == machines::pixel_transistors(point.job.machine, one.used_bits + 24));
}

TEST_CASE("a sweep's point that does not fit has a reason and the others are measured") {
  std::vector<Drawn> all = drawn_points();
  all[1].job.machine.array.memory_bits = 40;
  CHECK(measured(all[0], false).is_compiled());
  CHECK(measured(all[1], false).reason.find("memory bits") != std::string::npos);
  CHECK(measured(all[2], false).is_compiled());
}

TEST_CASE("the page of a sweep counts its models or names the only one") {
  const auto subject = [](Words words) {
    words.insert(words.begin(), "sweep");
    words.insert(words.end(), {"--output", "out"});
    session::OptionList list("sweep");
    const auto command = studies::add_study_options(list, studies::sweep_row);
    list.give_words(std::span(words).subspan(1));
    list.check_and_apply();
    return command->study->page_subject();
  };
  const std::string one = testing::model_path("thesis_fig_2_3");
  const std::string other = testing::model_path("old_example011");
  CHECK(subject({one, other}).name == "2 models");
  CHECK(subject({one}).name.empty());
  CHECK(subject({one}).model.model == one);
}

TEST_CASE("Hash::text() is the FNV-1a hash in hexadecimal digits") {
  Hash hash;
  hash.add("foobar");
  CHECK(hash.text() == "85944171f73967e8");
}
