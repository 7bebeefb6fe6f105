#include "tests/unit/plots/sample_plots.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace csgsim::testing::plots_ {

namespace {

using namespace plots;

double uniform(std::mt19937& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
}

std::size_t below(std::mt19937& random, std::size_t count) { return random() % count; }

std::string random_name(std::mt19937& random) {
  static const std::vector<std::string> pieces{
      "a",  "pixel-planes-4", "\xff\xfe", "%s%n%d", "\"'`",  "\n", "W", "\u00e9", "\u5b57",
      "$x", "{/Symbol a}_^@", "EOD\n",    "iiii",   "m = 5", " ",  "/", "#"};
  std::string name;
  for (std::size_t i = below(random, 4) == 0 ? 60 : below(random, 5); i > 0; --i)
    name += pieces[below(random, pieces.size())];
  return name;
}

double random_value(std::mt19937& random, std::size_t sort) {
  switch (sort) {
    case 0: return static_cast<double>(below(random, 4));
    case 1: return std::pow(10, uniform(random, -12, 20));
    case 2: return 1e9 + static_cast<double>(below(random, 5));
    case 3: return uniform(random, -5, 5);
    case 4: return below(random, 3) == 0 ? 0 : std::pow(10, uniform(random, 0, 5));
    default: return uniform(random, 200'000, 450'000);
  }
}

Chart one_series(std::vector<plots::Point> points) {
  return {"one series", {"x"}, {{"y"}}, {{"values", 0, Trace::line, std::move(points)}}, "table.csv"};
}

Chart many_labels(std::size_t count) {
  std::vector<plots::Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    const auto t = static_cast<double>(i);
    points.push_back({std::fmod(t * 37, 50), 100 + std::fmod(t * t, 97), "label " + std::to_string(i)});
  }
  return {"many labels", {"x"}, {{"y"}}, {{"marks", 0, Trace::marks, points}}, "table.csv"};
}

constexpr Trace traces[] = {Trace::line, Trace::steps, Trace::marks, Trace::line, Trace::level, Trace::upright};

Chart many_series(std::size_t count, const std::string& name) {
  Chart chart{"many series of " + name, {name}, {{name}, {"other"}}, {}, "table.csv"};
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t panel = 0; panel < 2; ++panel) {
      plots::Series series{name + std::to_string(i), panel, traces[i % std::size(traces)], {}};
      for (std::size_t x = 0; x < 8; ++x)
        series.points.push_back({static_cast<double>(x), static_cast<double>((i + 1) * (x + 2))});
      chart.series.push_back(std::move(series));
    }
  }
  return chart;
}

Chart names_on_axis(std::size_t count, const std::string& name) {
  Chart chart{"names", {"machine", Scale::linear, {}, true}, {{"ms"}}, {{"", 0, Trace::marks, {}}}, "table.csv"};
  for (std::size_t i = 0; i < count; ++i) {
    chart.x.ticks.push_back({static_cast<double>(i), name + std::to_string(i) + name});
    chart.series[0].points.push_back({static_cast<double>(i), static_cast<double>(1 + i * i)});
  }
  return chart;
}

}  // namespace

std::vector<Plot> sample_plots() {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const std::string hostile = "a'\"\n`touch PWNED`%d\\ {}_^ <b> \xff $(x) \u202e" + std::string(200, 'W');
  std::vector<Plot> all{
      {"one_point", one_series({{3, 7, "alone"}})},
      {"no_point", one_series({})},
      {"no_number", one_series({{infinite, 1}, {1, std::nan("")}})},
      {"equal_points", one_series({{3, 7, "one"}, {3, 7, "other"}})},
      {"zero", one_series({{0, 0, "zero"}})},
      {"zeros_and_more", one_series({{1, 0, "none"}, {2, 3}, {3, 40'000, "many"}, {4, 0}})},
      {"huge_range", one_series({{1e-300, 1e-12, "small"}, {1, 1}, {1e300, 1e20, "large"}})},
      {"beyond", one_series({{-1.7e308, -1.7e308}, {1.7e308, 1.7e308}})},
      {"next_doubles", one_series({{1e15, 1e15}, {1e15 + 1, std::nextafter(1e15, 2e15)}})},
      {"close", one_series({{8, 280'965}, {9, 280'966}, {10, 280'965}})},
      {"negative", one_series({{-8, -28}, {9, 280'966}})},
      {"labels_20", many_labels(20)},
      {"labels_200", many_labels(200)},
      {"series_8", many_series(8, "series ")},
      {"series_30_hostile", many_series(30, hostile)},
      {"names_5", names_on_axis(5, "machine-")},
      {"names_40", names_on_axis(40, "machine-")},
      {"names_200_hostile", names_on_axis(200, hostile)},
  };
  plots::Bars bars{"bars", {"bit"}, {}, {"Z2", "Z1"}, "table.csv"};
  for (std::size_t i = 0; i < 60; ++i) {
    plots::Bar bar{i % 2 == 0 ? hostile + std::to_string(i) : "list", 72 + static_cast<double>(i), {}};
    for (std::size_t part = 0; part < 12; ++part) {
      bar.parts.push_back({part == 0 ? "Z2" : "p" + std::to_string(part), static_cast<double>(part * 6),
                           static_cast<double>(part * 6 + 5)});
    }
    bars.bars.push_back(std::move(bar));
  }
  all.push_back({"bars_60", bars});
  bars.bars.clear();
  all.push_back({"bars_none", bars});
  return all;
}

plots::Chart random_chart(std::mt19937& random) {
  Chart chart{random_name(random), {random_name(random), static_cast<Scale>(below(random, 3))}, {}, {}, "table.csv"};
  const std::size_t panels = 1 + below(random, 3);
  for (std::size_t i = 0; i < panels; ++i)
    chart.panels.push_back({random_name(random), static_cast<Scale>(below(random, 3))});
  const std::size_t x_sort = below(random, 6);
  chart.x.is_names = below(random, 4) == 0;
  for (std::size_t i = chart.x.is_names || below(random, 2) == 0 ? 1 + below(random, 30) : 0; i > 0; --i) {
    const auto number = static_cast<double>(chart.x.ticks.size());
    chart.x.ticks.push_back(
        {chart.x.is_names ? number : random_value(random, x_sort), random_name(random) + std::to_string(i)});
  }
  for (std::size_t i = below(random, 20); i > 0; --i) {
    plots::Series series{
        random_name(random), below(random, panels), static_cast<Trace>(below(random, 3)), {}, below(random, 5) == 0};
    const std::size_t y_sort = below(random, 6);
    for (std::size_t point = below(random, 4) == 0 ? 40 : below(random, 8); point > 0; --point) {
      const double x =
          chart.x.is_names ? static_cast<double>(below(random, chart.x.ticks.size())) : random_value(random, x_sort);
      series.points.push_back({x, random_value(random, y_sort), below(random, 2) == 0 ? random_name(random) : ""});
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

plots::Bars random_bars(std::mt19937& random) {
  plots::Bars bars{random_name(random), {random_name(random)}, {}, {"Z2", "Z1", "colour"}, "table.csv"};
  for (std::size_t i = below(random, 50); i > 0; --i) {
    plots::Bar bar{random_name(random), static_cast<double>(1 + below(random, 300)), {}};
    for (double at = 0; at < bar.length;) {
      const double end = std::min(bar.length, at + static_cast<double>(1 + below(random, 40)));
      bar.parts.push_back({random_name(random), at, end});
      at = end + static_cast<double>(below(random, 10));
    }
    bars.bars.push_back(std::move(bar));
  }
  return bars;
}

}  // namespace csgsim::testing::plots_
