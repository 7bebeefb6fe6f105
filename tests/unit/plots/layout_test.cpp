#include "sim/plots/layout.h"

#include "sim/plots/text_size.h"
#include "tests/support/test.h"
#include "tests/unit/plots/sample_plots.h"

using namespace csgsim;
namespace samples = csgsim::testing::plots_;

namespace {

void check_texts(const plots::Drawing& drawing) {
  const plots::Box picture{0, 0, drawing.width, drawing.height};
  for (std::size_t i = 0; i < drawing.texts.size(); ++i) {
    const plots::Text& text = drawing.texts[i];
    CAPTURE(text.text);
    CHECK(plots::is_within(plots::bounding_box(text), picture));
    for (std::size_t j = 0; j < i; ++j) {
      CAPTURE(drawing.texts[j].text);
      CHECK(!plots::boxes_overlap(plots::bounding_box(text), plots::bounding_box(drawing.texts[j])));
    }
  }
}

void check_marks_and_lines(const plots::Drawing& drawing) {
  const plots::Box picture{0, 0, drawing.width, drawing.height};
  for (const plots::Mark& mark : drawing.marks)
    CHECK(plots::is_within(plots::square_around(mark.at, mark.size / 2), picture));
  for (const plots::Line& line : drawing.lines) {
    for (const plots::Pixel& point : line.points) CHECK(plots::is_within(plots::square_around(point, 0), picture));
  }
}

void check(const plots::Drawing& drawing) {
  check_texts(drawing);
  check_marks_and_lines(drawing);
}

/// Returns the texts of a drawing that contain the words.
std::vector<std::string> with(const plots::Drawing& drawing, const std::string& words) {
  std::vector<std::string> found;
  for (const plots::Text& text : drawing.texts) {
    if (text.text.find(words) != std::string::npos) found.push_back(text.text);
  }
  return found;
}

plots::Chart make_chart(std::size_t series) {
  plots::Chart chart{"title", {"across"}, {{"up"}}, {}, "table.csv"};
  for (std::size_t i = 0; i < series; ++i) {
    // The third series of every four is the largest.
    const double height = static_cast<double>(i) + (i % 4 == 2 ? 100 : 0);
    chart.series.push_back({"series " + std::to_string(i), 0, plots::Trace::line, {{0, height}, {1, height}}});
  }
  return chart;
}

}  // namespace

TEST_CASE("no two texts of a plot overlap and nothing leaves the picture") {
  for (const plots::Plot& plot : samples::sample_plots()) {
    CAPTURE(plot.name);
    check(plots::lay_out(plot));
  }
}

TEST_CASE("no two texts of random plots overlap") {
  const auto seeds = testing::cases<unsigned>(300, 30);
  for (unsigned seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    check(plots::lay_out(samples::random_chart(random)));
    check(plots::lay_out(samples::random_bars(random)));
  }
}

TEST_CASE("the key names the largest series and states how many others the table has") {
  const plots::Drawing drawing = plots::lay_out(make_chart(20));
  CHECK(with(drawing, "series ").size() == plots::palette::max_series);
  for (const char* name :
       {"series 2", "series 6", "series 10", "series 14", "series 18", "series 19", "series 17", "series 16"})
    CHECK(with(drawing, name).size() == 1);
  CHECK(with(drawing, "12 more") == std::vector<std::string>{"12 more, with smaller values (see table.csv)"});
  CHECK(with(plots::lay_out(make_chart(8)), "more").empty());
}

TEST_CASE("series listed in the key have distinct colours and all others are grey") {
  const plots::Drawing drawing = plots::lay_out(make_chart(20));
  std::multiset<std::string_view> colours;
  for (const plots::Mark& mark : drawing.marks) colours.insert(mark.colour);
  for (const plots::palette::Look& look : plots::palette::looks) CHECK(colours.count(look.colour) == 3);
  CHECK(colours.count(plots::palette::background.colour) == 2 * 12 + 1);
}

TEST_CASE("a long title of the y axis is split into two lines between words") {
  const plots::Drawing drawing = plots::lay_out(
      plots::Chart{"title", {"across"}, {{"depth error, 99.9th percentile"}, {"up"}, {"also"}}, {{"s", 0}}, "t"});
  const std::vector<std::string> first = with(drawing, "depth");
  const std::vector<std::string> second = with(drawing, "percentile");
  REQUIRE(first.size() == 1);
  REQUIRE(second.size() == 1);
  CHECK(first[0] + " " + second[0] == "depth error, 99.9th percentile");
  CHECK(plots::split_lines("one two", 1000) == std::vector<std::string>{"one two"});
  CHECK(plots::split_lines("MMMMMMMMMMMM", 50).size() == 1);
  check(drawing);
}

TEST_CASE("a value axis starts from 0 if the other axis shows names") {
  plots::Chart chart{"title", {"machine", plots::Scale::linear, {{0, "a"}, {1, "b"}}, true}, {{"ms"}}, {}, "t"};
  chart.series.push_back({"", 0, plots::Trace::marks, {{0, 21.5}, {1, 22.8}}});
  CHECK(with(plots::lay_out(chart), "0").front() == "0");
  CHECK(with(plots::lay_out(chart), "21").empty());
}

TEST_CASE("positions of points are proportional to their values and match the ticks") {
  const plots::Drawing drawing = plots::lay_out(
      plots::Chart{"title", {"x"}, {{"y"}}, {{"", 0, plots::Trace::marks, {{0, 0}, {1, 3}, {4, 4}}}}, "t"});
  REQUIRE(drawing.marks.size() == 3);
  const plots::Pixel first{drawing.marks[1].at.x - drawing.marks[0].at.x,
                           drawing.marks[1].at.y - drawing.marks[0].at.y};
  const plots::Pixel second{drawing.marks[2].at.x - drawing.marks[1].at.x,
                            drawing.marks[2].at.y - drawing.marks[1].at.y};
  CHECK(first.x > 80);
  CHECK(first.y < -200);
  CHECK(second.x == doctest::Approx(3 * first.x));
  CHECK(first.y == doctest::Approx(3 * second.y));
  // The texts of 4, across and up, are below the point at 4,4 and left of it.
  std::vector<plots::Pixel> fours;
  for (const plots::Text& text : drawing.texts) {
    if (text.text == "4" || text.text == "4.0") fours.push_back(text.at);
  }
  REQUIRE(fours.size() == 2);
  CHECK(std::ranges::any_of(fours, [&](const plots::Pixel& at) { return at.x == drawing.marks[2].at.x; }));
  CHECK(std::ranges::any_of(fours, [&](const plots::Pixel& at) { return at.y == drawing.marks[2].at.y; }));
}

TEST_CASE("a series joins its points by lines or steps or a level line or not at all") {
  const auto joined = [](plots::Trace trace, bool is_backward = false) {
    plots::Chart chart{"title", {"x"}, {{"y"}}, {{"", 0, trace, {{0, 0}, {5, 10}, {10, 20}}}}, "t"};
    if (is_backward) std::ranges::reverse(chart.series.front().points);
    for (const plots::Line& line : plots::lay_out(chart).lines) {
      if (line.width == 2) return line.points;
    }
    return std::vector<plots::Pixel>();
  };
  const std::vector<plots::Pixel> line = joined(plots::Trace::line);
  REQUIRE(line.size() == 3);
  const std::vector<plots::Pixel> steps = joined(plots::Trace::steps);
  REQUIRE(steps.size() == 6);
  CHECK(steps[1] == plots::Pixel{line[1].x, line[0].y});
  CHECK(steps[2] == line[1]);
  // Steps go right where x increases and left where it decreases.
  CHECK(steps.back() == plots::Pixel{plots::plot_width - 30, line[2].y});
  CHECK(joined(plots::Trace::steps, true).back().x < line[0].x);
  CHECK(joined(plots::Trace::marks).empty());
  const std::vector<plots::Pixel> level = joined(plots::Trace::level);
  CHECK(level.front().y == level.back().y);
  CHECK(level.front().x < level.back().x - 500);
  const std::vector<plots::Pixel> upright = joined(plots::Trace::upright);
  CHECK(upright.front().x == upright.back().x);
  CHECK(upright.front().y < upright.back().y - 300);
}

TEST_CASE("labels of points at the same position are joined into one text") {
  const plots::Chart chart{"title",
                           {"across"},
                           {{"up"}},
                           {{"s", 0, plots::Trace::marks, {{1, 1, "m = 5"}, {1, 1, "m = 6"}, {2, 3, "m = 7"}}}},
                           "t"};
  const plots::Drawing drawing = plots::lay_out(chart);
  CHECK(with(drawing, "m = 5") == std::vector<std::string>{"m = 5, m = 6"});
  CHECK(with(drawing, "m = 7").size() == 1);
}

TEST_CASE("labels without room are listed by number and the rest are counted in the key") {
  plots::Chart chart{"title", {"across"}, {{"up"}}, {{"s", 0, plots::Trace::marks, {}}}, "table.csv"};
  for (std::size_t i = 0; i < 200; ++i)
    chart.series[0].points.push_back(
        {static_cast<double>(i % 4), static_cast<double>(i) / 1000, "point " + std::to_string(i)});
  chart.series[0].points.push_back({0, 100, ""});
  const plots::Drawing drawing = plots::lay_out(chart);
  const std::vector<std::string> more = with(drawing, "more labels in table.csv");
  REQUIRE(more.size() == 1);
  CHECK(with(drawing, ": point ").size() > 3);
  // Points at one place share a label, which lists all names that fit.
  CHECK(with(drawing, "point ").size() + std::stoul(more[0]) <= 200);
}

TEST_CASE("names on an axis are upright if they do not fit and some are omitted if too many") {
  const auto axis = [](std::size_t count) {
    plots::Chart chart{
        "title", {"machine", plots::Scale::linear, {}, true}, {{"ms"}}, {{"", 0, plots::Trace::marks, {}}}, "t"};
    for (std::size_t i = 0; i < count; ++i) {
      chart.x.ticks.push_back({static_cast<double>(i), "machine " + std::to_string(i)});
      chart.series[0].points.push_back({static_cast<double>(i), 1});
    }
    return plots::lay_out(chart);
  };
  const auto upright = [](const plots::Drawing& drawing) {
    return std::ranges::count_if(drawing.texts,
                                 [](const plots::Text& text) { return text.is_upright && text.text != "ms"; });
  };
  CHECK(upright(axis(5)) == 0);
  CHECK(with(axis(5), "machine ").size() == 5);
  CHECK(upright(axis(30)) == 30);
  CHECK(upright(axis(300)) < 60);
  CHECK(upright(axis(300)) > 20);
}

TEST_CASE("a plot counts the bars beyond the displayed maximum") {
  plots::Bars bars{"title", {"bit"}, {}, {}, "table.csv"};
  for (std::size_t i = 0; i < plots::max_bars + 7; ++i)
    bars.bars.push_back({"bar " + std::to_string(i), 8, {{"Z1", 0, 4}}});
  const plots::Drawing drawing = plots::lay_out(bars);
  CHECK(with(drawing, "bar ").size() == plots::max_bars);
  CHECK(with(drawing, "7 more bars in table.csv").size() == 1);
}

TEST_CASE("signed bars extend from 0 to both sides and show signed values") {
  plots::Bars bars{"title", {"%"}, {{"gate.delay", 32, {{"low", -29.5, 0}, {"high", 0, 32}}}}, {}, "table.csv", true};
  const plots::Drawing drawing = plots::lay_out(bars);
  check(drawing);
  CHECK(with(drawing, "free").empty());
  CHECK(with(drawing, "-29.5").size() == 1);
  CHECK(with(drawing, "+32").size() == 1);
  REQUIRE(drawing.fills.size() >= 3);
  CHECK(drawing.fills[1].box.right == drawing.fills[2].box.left);
  CHECK(drawing.fills[1].box.left < drawing.fills[1].box.right);
}

TEST_CASE("shortened names still differ and fit the maximum width") {
  const std::string middle(80, 'x');
  const std::vector<std::string> names{"begin" + middle + "1" + middle + "end", "begin" + middle + "2" + middle + "end",
                                       "short", "begin" + middle + "1" + middle + "end"};
  const std::vector<std::string> shown = plots::shorten(names, 120);
  CHECK(shown[0] != shown[1]);
  CHECK(shown[0] == shown[3]);
  CHECK(shown[2] == "short");
  for (const std::string& text : shown) CHECK(plots::text_width(text) <= 120);
}