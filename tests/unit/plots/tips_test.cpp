#include "sim/plots/tips.h"

#include "sim/plots/layout.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

const plots::Chart chart{"title",
                         {"bits", plots::Scale::linear, {{3, "3 of 8"}}},
                         {{"clocks"}, {"ms"}},
                         {{"list", 0, plots::Trace::line, {{3, 1234567, "m = 5"}, {4, 0.123456, "list"}}},
                          {"", 1, plots::Trace::level, {{3, 2.5}}}},
                         "t.csv"};

}  // namespace

TEST_CASE("a point's tip names its series and label and both values with their axes") {
  const plots::Series& series = chart.series[0];
  CHECK(plots::tip_text(chart, series, series.points[0]) == "list, m = 5: bits 3 of 8, clocks 1,234,567");
  CHECK(plots::tip_text(chart, series, series.points[1]) == "list: bits 4, clocks 0.1235");
  CHECK(plots::tip_text(chart, chart.series[1], {4, 2.5}) == "bits 4, ms 2.5");
}

TEST_CASE("the tip of a bar's part names the bar and the part's range") {
  const plots::Bars bars{"title", {"bit"}, {{"stack", 72, {{"Z2", 0, 20}}}}, {}, "t.csv"};
  CHECK(plots::tip_text(bars, bars.bars[0], bars.bars[0].parts[0]) == "stack: Z2, bit 0 to 20");
  const plots::Drawing drawing = plots::lay_out(bars);
  const auto count = std::ranges::count_if(
      drawing.fills, [](const plots::Fill& fill) { return fill.tip == "stack: Z2, bit 0 to 20"; });
  CHECK(count == 1);
}

TEST_CASE("every point and level has a tip in the drawing but samples of the key have none") {
  const plots::Drawing drawing = plots::lay_out(chart);
  const auto has_tip = [](const auto& one) { return !one.tip.empty(); };
  CHECK(std::ranges::count_if(drawing.marks, has_tip) == 2);
  CHECK(drawing.marks.size() == 3);
  CHECK(std::ranges::count_if(drawing.lines, has_tip) == 1);
}