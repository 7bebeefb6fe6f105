// Tests of csgsim explore's output for made-up rows: axes, groups, the JSON file, the text and the plots. All expected
// figures are calculated by hand.

#include <doctest/doctest.h>
#include <unistd.h>

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sim/plots/plot.h"
#include "sim/studies/design/front.h"
#include "sim/studies/design/row.h"
#include "sim/studies/explore/show.h"
#include "sim/studies/row_text.h"
#include "tests/support/captured.h"

using namespace csgsim;
using studies::ExploreRow;
using studies::ShownGroup;
using studies::Values;
using Json = nlohmann::ordered_json;

namespace {

/// A row of a design identified by a figure and the z bits.
ExploreRow shown_row(const std::string& model, const char* alu_bits, unsigned z_bits, double fps, std::uint64_t bits) {
  ExploreRow one;
  one.point.model = model;
  one.point.machine = std::string("pixel-planes-4+alu.bits=") + alu_bits;
  one.point.width = 8;
  one.point.height = 6;
  one.point.z_bits = z_bits;
  one.point.strategy = "stack";
  one.point.curves = "auto";
  one.point.pruning = "all";
  one.frames_per_second = fps;
  one.machine_memory_bits = bits;
  return one;
}

ExploreRow refused_row(const std::string& model, const char* alu_bits, unsigned z_bits, const std::string& reason) {
  ExploreRow one = shown_row(model, alu_bits, z_bits, 0, 0);
  one.reason = reason;
  return one;
}

std::vector<ShownGroup> shown_groups(const std::vector<ExploreRow>& rows, const std::string& axes) {
  std::vector<ShownGroup> shown;
  for (studies::ExploreGroup& group : studies::groups_of(rows, studies::parse_axes(axes)))
    shown.push_back({std::move(group), {}});
  return shown;
}

std::string printed(const std::vector<ExploreRow>& rows, const std::vector<ShownGroup>& groups) {
  const testing::Captured output(STDOUT_FILENO);
  studies::print_explored(rows, groups);
  return output.text();
}

/// Two models on designs a (1 bit, z 8), b (4 bits, z 8) and c (4 bits, z 12). Model m draws all: a takes 100 ms and 10
/// bits, b 50 ms and 40 bits, c 100 ms and 40 bits, which is worse than either. Model n cannot draw c: a takes 20 ms
/// and 30 bits, b 25 ms and 40 bits, which is worse.
std::vector<ExploreRow> two_models() {
  return {shown_row("m", "1", 8, 10, 10), shown_row("m", "4", 8, 20, 40), shown_row("m", "4", 12, 10, 40),
          shown_row("n", "1", 8, 50, 30), shown_row("n", "4", 8, 40, 40), refused_row("n", "4", 12, "too large")};
}

}  // namespace

TEST_CASE("the column names of sweep and accuracy and advise and explore match their rows") {
  const auto visited = []<class Row>(Row row) {
    std::string names;
    Row::columns(
        row, [&](const char* name, const auto& /*value*/) { names += (names.empty() ? "" : ",") + std::string(name); });
    return names;
  };
  CHECK(visited(studies::SweepRow()) == studies::sweep_columns);
  CHECK(visited(studies::Measurement()) == studies::accuracy_columns);
  CHECK(visited(studies::AdviceRow()) == studies::advise_columns);
  CHECK(visited(studies::ExploreRow()) == studies::explore_columns);
}

TEST_CASE("an empty row of explore has zeros and empty cells in the order of its columns") {
  CHECK(studies::header_line<ExploreRow>() ==
        "model,machine,process,memory_bits,width,height,z_bits,fraction_bits,colour_bits,pruning,colouring,strategy,"
        "stack_bits,curves,model_hash,machine_hash,csgsim,halfspaces,instructions,clock_hz,clock_path,clocks,"
        "interval_clocks,frames_per_second,used_bits,processors,machine_memory_bits,pixel_transistors,"
        "machine_transistors,machine_mm2,frame_joules,wrong,unexplained,reason");
  CHECK(studies::to_line(ExploreRow{}) == ",,,,0,0,0,0,0,,,,0,,,,,0,0,0,,0,0,0,0,0,0,,,,,0,0,");
  // The columns before the inputs identify the point.
  CHECK(ExploreRow::point_columns == 14);
  CHECK(ExploreRow{}.is_compiled());
  CHECK_FALSE(refused_row("m", "1", 8, "why").is_compiled());
}

TEST_CASE("each axis of explore reads its value from a row, which may have none") {
  ExploreRow row;
  row.frames_per_second = 40;  // 25 ms each
  row.machine_transistors = 7000;
  row.machine_mm2 = 12.5;
  row.frame_joules = 0.75;
  row.machine_memory_bits = 900;
  row.wrong = 3;
  struct Expected {
    std::string name;
    double value;
    bool is_of_picture;
    bool may_be_zero;
  };
  const std::array<Expected, 6> expected{{{"time", 25, true, false},
                                          {"area", 7000, false, false},
                                          {"silicon", 12.5, false, false},
                                          {"energy", 0.75, true, false},
                                          {"memory", 900, false, false},
                                          {"wrong", 3, true, true}}};
  REQUIRE(studies::explore_axes().size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const studies::ExploreAxis& axis = studies::explore_axes()[i];
    const std::string name = axis.name;
    CAPTURE(name);
    CHECK(name == expected[i].name);
    CHECK(studies::explore_axis_names()[i] == expected[i].name);
    CHECK(axis.value(row) == expected[i].value);
    CHECK(axis.is_of_picture == expected[i].is_of_picture);
    CHECK(axis.may_be_zero == expected[i].may_be_zero);
    const bool has_price = name == "time" || name == "memory" || name == "wrong";
    ExploreRow unpriced;
    unpriced.frames_per_second = 40;
    CHECK(axis.value(unpriced).has_value() == has_price);
  }
  // Axes keep their order in the list.
  const std::vector<studies::ExploreAxis> axes = studies::parse_axes("wrong,time");
  REQUIRE(axes.size() == 2);
  CHECK(std::string(axes[0].name) == "wrong");
  CHECK(std::string(axes[1].name) == "time");
}

TEST_CASE("a design for two models takes the larger silicon area and the sum of energies") {
  std::vector<ExploreRow> rows{shown_row("m", "1", 8, 10, 10), shown_row("n", "1", 8, 10, 10)};
  rows[0].machine_mm2 = 3;
  rows[1].machine_mm2 = 2;
  rows[0].frame_joules = 5;
  rows[1].frame_joules = 7;
  const std::vector<studies::ExploreGroup> groups = studies::groups_of(rows, studies::parse_axes("silicon,energy"));
  REQUIRE(groups.size() == 3);
  CHECK(groups[2].values == std::vector<Values>{{3, 12}});
}

TEST_CASE("the knee of a group is a design on its front") {
  const std::vector<studies::ExploreAxis> axes = studies::parse_axes("time,memory");
  // The logarithms (0, 2), (1, 1), (2, 0) of the designs on the front are scaled to (0, 1), (1/2, 1/2), (1, 0).
  const std::vector<Values> candidates{{0.001, 0.001}, {1, 100}, {10, 10}, {100, 1}, {1e6, 1e6}};
  CHECK(studies::find_knee(candidates, {false, true, true, true, false}, axes) == 2);
  // Without the middle design, both ends are at distance 1, and the first is chosen.
  CHECK(studies::find_knee(candidates, {false, true, false, true, false}, axes) == 1);
  CHECK(studies::find_knee(candidates, {false, false, false, true, false}, axes) == 3);
  CHECK_FALSE(studies::find_knee(candidates, {false, false, false, false, false}, axes));
}

TEST_CASE("a design is marked in its model's group and all models have a separate front") {
  const std::vector<ExploreRow> rows = two_models();
  std::vector<ShownGroup> groups = shown_groups(rows, "time,memory");
  REQUIRE(groups.size() == 3);
  groups[0].commands = {"draw m"};
  const Json file = Json::parse(studies::explore_json("the title", rows, groups));
  REQUIRE(file["points"].size() == 6);
  const Json& points = file["points"];
  for (std::size_t i = 0; i < 6; ++i) CHECK(points[i]["model"] == (i < 3 ? "m" : "n"));
  CHECK(points[0]["design"] == Json::parse(R"({"alu.bits":1,"z-bits":8})"));
  CHECK(points[5]["design"] == Json::parse(R"({"alu.bits":4,"z-bits":12})"));
  // m: a and b are on the front, at (log 100, log 10) and (log 50, log 40): both are ends, so the first is the knee.
  const std::array<int, 6> on_front{1, 1, 0, 1, 0, -1};
  const std::array<int, 6> is_knee{1, 0, 0, 1, 0, -1};
  for (std::size_t i = 0; i < 6; ++i) {
    CAPTURE(i);
    CHECK(points[i].contains("pareto") == (on_front[i] >= 0));
    CHECK(points[i].contains("knee") == (is_knee[i] >= 0));
    if (on_front[i] < 0) continue;
    CHECK(points[i]["pareto"] == (on_front[i] == 1));
    CHECK(points[i]["knee"] == (is_knee[i] == 1));
  }
  CHECK(points[5]["reason"] == "too large");
  const auto values = [](double ms, double bits) { return Json{{"time", ms}, {"memory", bits}}; };
  const Json a{{"alu.bits", 1}, {"z-bits", 8}};
  const Json b{{"alu.bits", 4}, {"z-bits", 8}};
  const Json expected = {
      {{"model", "m"},
       {"axes", {"time", "memory"}},
       {"designs", 3},
       {"refused", 0},
       {"unpriced", 0},
       {"front", {{{"design", a}, {"values", values(100, 10)}}, {{"design", b}, {"values", values(50, 40)}}}},
       {"knee", {{"design", a}, {"values", values(100, 10)}, {"commands", {"draw m"}}}}},
      {{"model", "n"},
       {"axes", {"time", "memory"}},
       {"designs", 3},
       {"refused", 1},
       {"unpriced", 0},
       {"front", Json::array({{{"design", a}, {"values", values(20, 30)}}})},
       {"knee", {{"design", a}, {"values", values(20, 30)}, {"commands", Json::array()}}}},
      // 100 + 20 ms and the larger of 10 and 30 bits; 50 + 25 ms and 40 bits.
      {{"model", nullptr},
       {"axes", {"time", "memory"}},
       {"designs", 3},
       {"refused", 1},
       {"unpriced", 0},
       {"front", {{{"design", a}, {"values", values(120, 30)}}, {{"design", b}, {"values", values(75, 40)}}}},
       {"knee", {{"design", a}, {"values", values(120, 30)}, {"commands", Json::array()}}}}};
  CHECK(file["fronts"] == expected);
}

TEST_CASE("whole values of a design are JSON numbers and absent ones are omitted") {
  std::vector<ExploreRow> rows(4);
  rows[0].point.machine = "p+a.b=12+c=x";
  rows[1].point.machine = "p+a.b=1.5+c=12x";
  rows[2].point.machine = "p+a.b=-3";
  rows[3].point.machine = "p+flag";
  for (ExploreRow& row : rows) row.frames_per_second = 1;
  const Json file = Json::parse(studies::explore_json("t", rows, shown_groups(rows, "time")));
  const Json& points = file["points"];
  CHECK(points[0]["design"] == Json{{"a.b", 12}, {"c", "x"}});
  CHECK(points[1]["design"] == Json{{"a.b", "1.5"}, {"c", "12x"}});
  CHECK(points[2]["design"] == Json{{"a.b", -3}});
  CHECK(points[3]["design"] == Json::object());
}

TEST_CASE("a group without a drawn design has no front and prints its number of designs") {
  std::vector<ExploreRow> rows{refused_row("m", "1", 8, "no"), refused_row("m", "2", 8, "no")};
  const std::vector<ShownGroup> groups = shown_groups(rows, "time");
  const Json file = Json::parse(studies::explore_json("t", rows, groups));
  CHECK(file["fronts"] == Json::array({Json{{"model", "m"},
                                            {"axes", Json::array()},
                                            {"designs", 2},
                                            {"refused", 2},
                                            {"unpriced", 0},
                                            {"front", Json::array()}}}));
  CHECK(printed(rows, groups) ==
        "m: 0 of 2 designs on the front; 2 cannot be drawn\n"
        "  alu.bits=1 and 1 other design cannot be drawn: no\n");
}

TEST_CASE("the printed text of a design has each parameter and option that differs") {
  std::vector<ExploreRow> rows(2);
  const auto fill = [](studies::DesignPoint& point, unsigned number) {
    const std::string text = std::to_string(number);
    point.machine = "p+b=" + text + "+a=" + text;
    point.width = number;
    point.height = number + 1;
    point.memory_bits = number;
    point.z_bits = number;
    point.fraction_bits = number;
    point.colour_bits = number;
    point.strategy = "s" + text;
    point.stack_bits = number - 1;
    point.colouring = "c" + text;
    point.curves = "u" + text;
    point.pruning = "p" + text;
  };
  fill(rows[0].point, 1);
  fill(rows[1].point, 2);
  const studies::DesignNames names(rows);
  CHECK(names.keys() == std::vector<std::string>{"b", "a", "size", "memory-bits", "z-bits", "fraction-bits",
                                                 "colour-bits", "strategy", "stack-bits", "colouring", "curves",
                                                 "pruning"});
  CHECK(names.values(rows[1].point) ==
        std::vector<std::string>{"2", "2", "2x3", "2", "2", "2", "2", "s2", "1", "c2", "u2", "p2"});
  // Strategies without stack bits print none.
  CHECK(names.text(rows[0].point) ==
        "b=1, a=1, size=1x2, memory-bits=1, z-bits=1, fraction-bits=1, colour-bits=1, strategy=s1, colouring=c1, "
        "curves=u1, pruning=p1");
  rows[1].point.memory_bits.reset();
  const studies::DesignNames fitted(rows);
  CHECK(fitted.values(rows[1].point)[3].empty());
  // A single design is named by its machine.
  const studies::DesignNames alone(std::vector<ExploreRow>{rows[0]});
  CHECK(alone.keys().empty());
  CHECK(alone.text(rows[0].point) == "p+b=1+a=1");
}

TEST_CASE("explore prints a line per design of the front and the knee with its command") {
  std::vector<ExploreRow> rows = two_models();
  rows.push_back(rows[1]);  // a duplicate of design b
  rows.back().point.z_bits = 20;
  std::vector<ShownGroup> groups = shown_groups({rows.begin(), rows.end()}, "time,memory");
  groups[0].commands = {"draw m", "draw it again"};
  groups[0].group.unpriced = 1;
  std::vector<ShownGroup> first{groups[0], groups[1]};
  CHECK(printed(rows, first) ==
        "m: 3 of 5 designs on the front; 1 omitted because an axis has no value for them\n"
        "  alu.bits  z-bits  time between frames, ms  memory bits in total      \n"
        "         4       8                       50                    40      \n"
        "         1       8                      100                    10  knee\n"
        "knee: alu.bits=1, z-bits=8; time between frames, ms 100; memory bits in total 10\n"
        "  draw m\n"
        "  draw it again\n"
        "\n"
        "n: 1 of 3 designs on the front; 1 cannot be drawn\n"
        "  alu.bits=4, z-bits=12 cannot be drawn: too large\n"
        "  alu.bits  z-bits  time between frames, ms  memory bits in total      \n"
        "         1       8                       20                    30  knee\n"
        "knee: alu.bits=1, z-bits=8; time between frames, ms 20; memory bits in total 30\n");
}

TEST_CASE("explore prints each reason once with its first design and the number of others") {
  std::vector<ExploreRow> rows{refused_row("m", "1", 8, "no"),     refused_row("m", "1", 9, "never"),
                               refused_row("m", "2", 8, "no"),     refused_row("m", "2", 9, "no"),
                               refused_row("n", "1", 8, "no way"), shown_row("n", "1", 9, 10, 10)};
  const std::string text = printed(rows, shown_groups(rows, "time"));
  CHECK(text.find("  alu.bits=1, z-bits=8 and 2 other designs cannot be drawn: no\n"
                  "  alu.bits=1, z-bits=9 cannot be drawn: never\n\nn: ") != std::string::npos);
  CHECK(text.find("n: 1 of 2 designs on the front; 1 cannot be drawn\n"
                  "  alu.bits=1, z-bits=8 cannot be drawn: no way\n  alu.bits") != std::string::npos);
  // The group of all models does not repeat reasons.
  CHECK(text.find("no way") == text.rfind("no way"));
}

TEST_CASE("explore rounds to four digits, and from 10,000 up to whole numbers") {
  const std::vector<std::pair<double, std::string>> values{{0.123456, "0.1235"},
                                                           {3, "3"},
                                                           {0, "0"},
                                                           {1234.5678, "1235"},
                                                           {9999, "9,999"},
                                                           {9998.5, "9998"},  // rounds to even
                                                           {10000.4, "10,000"},
                                                           {12345.6, "12,346"},
                                                           {999'999'999'999'999, "999,999,999,999,999"},
                                                           {1e15, "1e+15"},
                                                           {-2, "-2"}};
  for (const auto& [value, shown_text] : values) {
    const std::string text = shown_text;
    CAPTURE(text);
    ExploreRow row = shown_row("m", "1", 8, 1, 1);
    ShownGroup shown;
    shown.group.model = "m";
    shown.group.axes = studies::parse_axes("time");
    shown.group.rows = {0};
    shown.group.values = {{value}};
    shown.group.front = {true};
    shown.group.knee = 0;
    CHECK(printed({row}, {shown}).find("; time between frames, ms " + text + "\n") != std::string::npos);
  }
}

TEST_CASE("explore prints the first 40 designs of a front and the number of others") {
  for (const std::size_t count : {39U, 40U, 41U, 1241U}) {
    CAPTURE(count);
    // Each design is faster and larger than the previous one.
    std::vector<ExploreRow> rows;
    for (std::size_t i = 0; i < count; ++i)
      rows.push_back(shown_row("m", "1", static_cast<unsigned>(i), static_cast<double>(1 + i), 1 + i));
    const std::string text = printed(rows, shown_groups(rows, "time,memory"));
    std::size_t lines = 0;
    for (const char letter : text) lines += letter == '\n' ? 1U : 0U;
    // The group, the columns, up to 40 designs and the knee; and the number of further ones.
    const std::size_t more = count > 40 ? count - 40 : 0;
    CHECK(lines == 3 + count - more + (more > 0 ? 1 : 0));
    CHECK((text.find(" more, in explore.json\n") != text.npos) == (more > 0));
    if (more == 1) CHECK(text.find("  and 1 more, in explore.json\n") != text.npos);
    if (more == 1201) CHECK(text.find("  and 1,201 more, in explore.json\n") != text.npos);
  }
}

TEST_CASE("each group with a knee has a plot with a unique name") {
  std::vector<ExploreRow> rows{shown_row("a/m.csg", "1", 8, 10, 10), shown_row("b/m.csg", "1", 8, 20, 20),
                               refused_row("c.csg", "1", 8, "no")};
  rows[0].wrong = 5;
  std::vector<ShownGroup> groups = shown_groups(rows, "time,memory,wrong");
  REQUIRE(groups.size() == 4);
  // No design draws c.csg, so no design draws all models.
  const std::vector<plots::Plot> plots = studies::plots_of_explore(groups);
  REQUIRE(plots.size() == 2);
  CHECK(plots[0].name == "m_front");
  CHECK(plots[1].name == "m-2_front");
  const auto& chart = std::get<plots::Chart>(plots[0].content);
  CHECK(chart.title == "m: trade-offs against time");
  CHECK(std::get<plots::Chart>(plots[1].content).title == "m-2: trade-offs against time");
  REQUIRE(chart.panels.size() == 2);
  CHECK(chart.panels[0].title == "memory bits in total");
  CHECK(chart.panels[1].title == "wrong pixels");
  // One design: the front, the front of two axes, and the knee, in each panel.
  REQUIRE(chart.series.size() == 6);
  for (std::size_t panel = 0; panel < 2; ++panel) {
    for (std::size_t i = 0; i < 3; ++i) {
      const plots::Series& series = chart.series[3 * panel + i];
      CHECK(series.name == std::array{"Pareto front", "front of the two axes", "knee"}.at(i));
      CHECK(series.panel == panel);
      REQUIRE(series.points.size() == 1);
      CHECK(series.points[0].x == doctest::Approx(100));
      CHECK(series.points[0].y == doctest::Approx(panel == 0 ? 10 : 5));
    }
  }
  CHECK(studies::plots_of_explore(shown_groups(rows, "time")).empty());
  rows.pop_back();
  const std::vector<plots::Plot> of_all = studies::plots_of_explore(shown_groups(rows, "time,memory"));
  REQUIRE(of_all.size() == 3);
  CHECK(of_all[2].name == "all_models_front");
  CHECK(std::get<plots::Chart>(of_all[2].content).title == "all models: trade-offs against time");
}

TEST_CASE("dominated designs are named in the legend of only the first panel") {
  std::vector<ExploreRow> rows{shown_row("m", "1", 8, 10, 10), shown_row("m", "4", 8, 5, 20)};
  const std::vector<plots::Plot> plots = studies::plots_of_explore(shown_groups(rows, "time,memory,wrong"));
  REQUIRE(plots.size() == 1);
  const auto& chart = std::get<plots::Chart>(plots[0].content);
  REQUIRE(chart.series.size() == 8);
  CHECK(chart.series[0].name == "dominated");
  CHECK(chart.series[4].name.empty());
  REQUIRE(chart.series[4].points.size() == 1);
  CHECK(chart.series[4].points[0].x == doctest::Approx(200));
}
