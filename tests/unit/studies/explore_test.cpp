#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sim/plots/plot.h"
#include "sim/studies/design/axes.h"
#include "sim/studies/design/front.h"
#include "sim/studies/design/grid.h"
#include "sim/studies/explore/show.h"

using namespace csgsim;
using studies::ExploreRow;
using studies::GridSequence;
using studies::Values;

namespace {

using Cell = std::vector<std::size_t>;

std::vector<Cell> cells_of(const std::vector<std::size_t>& sizes, std::uint64_t seed, std::size_t most) {
  GridSequence sequence(sizes, seed);
  std::vector<Cell> cells;
  while (cells.size() < most) {
    std::optional<Cell> cell = sequence.next();
    if (!cell) break;
    cells.push_back(std::move(*cell));
  }
  return cells;
}

/// Reference implementation of Pareto dominance: compares the candidate with each other one.
bool is_dominated(const std::vector<Values>& candidates, std::size_t index) {
  for (const Values& other : candidates) {
    bool is_nowhere_worse = true;
    bool is_somewhere_better = false;
    for (std::size_t axis = 0; axis < other.size(); ++axis) {
      if (other[axis] > candidates[index][axis]) is_nowhere_worse = false;
      if (other[axis] < candidates[index][axis]) is_somewhere_better = true;
    }
    if (is_nowhere_worse && is_somewhere_better) return true;
  }
  return false;
}

ExploreRow row(const std::string& model, const std::string& machine, double fps, std::uint64_t bits,
               std::uint64_t wrong, std::optional<std::uint64_t> transistors = 1000) {
  ExploreRow one;
  one.point.model = model;
  one.point.machine = machine;
  one.point.strategy = "stack";
  one.frames_per_second = fps;
  one.machine_memory_bits = bits;
  one.wrong = wrong;
  one.machine_transistors = transistors;
  return one;
}

}  // namespace

TEST_CASE("the front of designs equals that of pairwise comparison") {
  CHECK(rc::check([] {
    const auto axes = *rc::gen::inRange<std::size_t>(1, 5);
    const auto candidates = *rc::gen::container<std::vector<Values>>(
        rc::gen::container<Values>(axes, rc::gen::map(rc::gen::inRange(0, 6), [](int i) { return double(i); })));
    const std::vector<bool> front = studies::pareto_flags(candidates);
    RC_ASSERT(front.size() == candidates.size());
    for (std::size_t i = 0; i < candidates.size(); ++i) RC_ASSERT(front[i] != is_dominated(candidates, i));
  }));
}

TEST_CASE("the knee is nearest to the best values on logarithmic axes scaled to one length") {
  const std::vector<studies::ExploreAxis> time_memory = studies::parse_axes("time,memory");
  // Logarithms to base 10: (0, 3), (1, 1), (3, 0), scaled to (0, 1), (1/3, 1/3), (1, 0).
  const std::vector<Values> candidates{{1, 1000}, {10, 10}, {1000, 1}, {1, 1e9}};
  const std::vector<bool> front = studies::pareto_flags(candidates);
  CHECK(front == std::vector<bool>{true, true, true, false});
  CHECK(studies::find_knee(candidates, front, time_memory) == 1);
  CHECK(studies::find_knee({}, {}, time_memory) == std::nullopt);
  // An axis that is constant over the front does not count, and among equals the first is chosen.
  const std::vector<Values> alike{{5, 7}, {5, 7}};
  CHECK(studies::find_knee(alike, studies::pareto_flags(alike), time_memory) == 0);
  // 0 wrong pixels: log(1 + n) is 0, log 10, log 100.
  const std::vector<Values> pixels{{1, 99}, {10, 9}, {100, 0}};
  const std::vector<studies::ExploreAxis> time_wrong = studies::parse_axes("time,wrong");
  CHECK(studies::find_knee(pixels, studies::pareto_flags(pixels), time_wrong) == 1);
  // log 2 / log 100 is 0.15, log 22.7 / log 100 is 0.68: 0.483, less than 0.5 of (10, 9).
  const std::vector<Values> near{{1, 99}, {10, 9}, {22.7, 1}, {100, 0}};
  CHECK(studies::find_knee(near, studies::pareto_flags(near), time_wrong) == 2);
}

TEST_CASE("the knee of designs is on the front and does not depend on units") {
  CHECK(rc::check([] {
    const auto axes = studies::parse_axes("time,memory,area");
    const auto candidates = *rc::gen::nonEmpty(rc::gen::container<std::vector<Values>>(
        rc::gen::container<Values>(3, rc::gen::map(rc::gen::inRange(1, 50), [](int i) { return double(i); }))));
    const std::vector<bool> front = studies::pareto_flags(candidates);
    const std::optional<std::size_t> knee = studies::find_knee(candidates, front, axes);
    RC_ASSERT(knee.has_value());
    RC_ASSERT(front[*knee]);
    std::vector<Values> scaled = candidates;
    for (Values& values : scaled) values[1] *= 1024;
    const std::optional<std::size_t> again = studies::find_knee(scaled, front, axes);
    // Rounding may choose another of several candidates at the same distance.
    const auto distance = [&](std::size_t one) {
      double sum = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        double least = 1e300;
        double most = 0;
        for (std::size_t i = 0; i < candidates.size(); ++i) {
          if (!front[i]) continue;
          least = std::min(least, std::log2(candidates[i][axis]));
          most = std::max(most, std::log2(candidates[i][axis]));
        }
        if (most > least) sum += std::pow((std::log2(candidates[one][axis]) - least) / (most - least), 2);
      }
      return sum;
    };
    RC_ASSERT(std::abs(distance(*knee) - distance(*again)) < 1e-9);
    for (std::size_t i = 0; i < candidates.size(); ++i)
      if (front[i]) RC_ASSERT(distance(*knee) < distance(i) + 1e-9);
  }));
}

TEST_CASE("a sample has no repeated cell and longer ones extend it up to the whole grid") {
  CHECK(rc::check([] {
    const auto axes = *rc::gen::inRange<std::size_t>(1, 6);
    const auto sizes = *rc::gen::container<std::vector<std::size_t>>(axes, rc::gen::inRange<std::size_t>(1, 6));
    const auto seed = *rc::gen::arbitrary<std::uint32_t>();
    std::size_t all = 1;
    for (const std::size_t size : sizes) all *= size;
    RC_PRE(all < 4000);
    const std::vector<Cell> cells = cells_of(sizes, seed, all + 10);
    RC_ASSERT(cells.size() == all);
    RC_ASSERT(std::set<Cell>(cells.begin(), cells.end()).size() == all);
    for (const Cell& cell : cells) {
      RC_ASSERT(cell.size() == sizes.size());
      for (std::size_t axis = 0; axis < sizes.size(); ++axis) RC_ASSERT(cell[axis] < sizes[axis]);
    }
    const std::vector<Cell> fewer = cells_of(sizes, seed, all / 2);
    RC_ASSERT(std::equal(fewer.begin(), fewer.end(), cells.begin()));
  }));
}

TEST_CASE("a sample covers each axis evenly and another seed has other cells") {
  const std::vector<std::size_t> sizes{8, 5, 6, 10, 4};
  const std::vector<Cell> cells = cells_of(sizes, 1, 240);
  for (std::size_t axis = 0; axis < sizes.size(); ++axis) {
    std::map<std::size_t, std::size_t> times;
    for (const Cell& cell : cells) ++times[cell[axis]];
    CAPTURE(axis);
    CHECK(times.size() == sizes[axis]);
    const double expected = 240.0 / static_cast<double>(sizes[axis]);
    for (const auto& [value, count] : times) CHECK(std::abs(static_cast<double>(count) - expected) < 6);
  }
  CHECK(cells_of(sizes, 2, 240) != cells);
  CHECK(cells_of(sizes, 1, 240) == cells);
}

TEST_CASE("a grid of designs varies its last axis fastest") {
  CHECK(studies::grid_cell({2, 3}, 0) == Cell{0, 0});
  CHECK(studies::grid_cell({2, 3}, 1) == Cell{0, 1});
  CHECK(studies::grid_cell({2, 3}, 5) == Cell{1, 2});
}

TEST_CASE("designs are all combinations in order with equal ones merged") {
  const std::vector<studies::Dimension> dimensions{
      {"alu.bits", {"1", "2"}}, {"strategy", {"stack", "bits"}}, {"stack-bits", {"3", "4", "5"}}};
  const std::vector<session::ModelRequest> all = studies::DesignGrid({}, dimensions, {}).designs();
  REQUIRE(all.size() == 2 * (1 + 3));
  CHECK(all[0].machine == "pixel-planes-4+alu.bits=1");
  CHECK(all[0].strategy == "stack");
  CHECK(all[1].strategy == "bits");
  CHECK(all[1].stack_bits == 3);
  CHECK(all[7].machine == "pixel-planes-4+alu.bits=2");
  CHECK(all[7].stack_bits == 5);
  CHECK(studies::DesignGrid({}, dimensions, {5, 1}).designs().size() == 5);
  CHECK(studies::DesignGrid({}, dimensions, {500, 1}).designs().size() == 8);
}

TEST_CASE("designs that differ in one option or parameter are distinct") {
  const std::vector<studies::Dimension> pairs{{"size", {"32x32", "48x48"}},   {"memory-bits", {"72", "96"}},
                                              {"z-bits", {"12", "20"}},       {"fraction-bits", {"2", "12"}},
                                              {"colour-bits", {"12", "24"}},  {"strategy", {"list", "products"}},
                                              {"stack-bits", {"3", "4"}},     {"colouring", {"rebroadcast", "field"}},
                                              {"curves", {"auto", "facets"}}, {"pruning", {"all", "no-space"}}};
  REQUIRE(pairs.size() == studies::axis_keys().size());
  for (const studies::Dimension& pair : pairs) {
    CAPTURE(pair.key);
    CHECK(std::ranges::count(studies::axis_keys(), pair.key) == 1);
    session::ModelRequest base;
    if (pair.key == "stack-bits") base.strategy = "bits";
    CHECK(studies::DesignGrid(base, {pair}, {}).designs().size() == 2);
  }
  CHECK(studies::DesignGrid({}, {{"alu.bits", {"1", "2"}}}, {}).designs().size() == 2);
}

TEST_CASE("designs without a value on an axis are on no front and empty axes are dropped") {
  const std::vector<ExploreRow> rows{row("m", "a", 10, 100, 0), row("m", "b", 20, 50, 0, std::nullopt),
                                     row("m", "c", 5, 200, 0)};
  std::vector<studies::ExploreGroup> groups = studies::groups_of(rows, studies::parse_axes("time,area,memory"));
  REQUIRE(groups.size() == 1);
  CHECK(groups[0].unpriced == 1);
  CHECK(groups[0].rows == std::vector<std::size_t>{0, 2});
  CHECK(groups[0].front == std::vector<bool>{true, false});
  groups = studies::groups_of(rows, studies::parse_axes("time,memory"));
  CHECK(groups[0].unpriced == 0);
  CHECK(groups[0].front == std::vector<bool>{false, true, false});
  const std::vector<ExploreRow> none{row("m", "a", 10, 100, 0, std::nullopt), row("m", "b", 20, 150, 0, std::nullopt)};
  groups = studies::groups_of(none, studies::parse_axes("time,area,memory"));
  CHECK(groups[0].axes.size() == 2);
  CHECK(groups[0].front == std::vector<bool>{true, true});
}

TEST_CASE("a design's times and wrong pixels add up over models and sizes take the maximum") {
  std::vector<ExploreRow> rows{row("m", "a", 10, 100, 1), row("m", "b", 20, 50, 2), row("m", "c", 1000, 1, 0),
                               row("n", "a", 50, 300, 4), row("n", "b", 5, 20, 8),  row("n", "c", 1000, 1, 0)};
  rows[5].reason = "it does not fit";
  const std::vector<studies::ExploreGroup> groups = studies::groups_of(rows, studies::parse_axes("time,memory,wrong"));
  REQUIRE(groups.size() == 3);
  CHECK(groups[0].values.size() == 3);
  CHECK(groups[1].refused == 1);
  const studies::ExploreGroup& all = groups[2];
  CHECK(all.model.empty());
  CHECK(all.refused == 1);
  REQUIRE(all.values.size() == 2);
  CHECK(all.values[0][0] == doctest::Approx(100 + 20));
  CHECK(all.values[0][1] == 300);
  CHECK(all.values[0][2] == 5);
  CHECK(all.values[1][0] == doctest::Approx(50 + 200));
  CHECK(all.values[1][1] == 50);
  CHECK(all.values[1][2] == 10);
}

TEST_CASE("each panel plots every design once with the two-axis front and the knee") {
  const std::vector<ExploreRow> rows{row("a/m.csg", "a", 10, 100, 0), row("a/m.csg", "b", 20, 200, 4),
                                     row("a/m.csg", "c", 5, 300, 0), row("a/m.csg", "d", 40, 150, 9)};
  std::vector<studies::ShownGroup> shown;
  for (studies::ExploreGroup& group : studies::groups_of(rows, studies::parse_axes("time,memory,wrong")))
    shown.push_back({std::move(group), {}});
  const std::vector<plots::Plot> plots = studies::plots_of_explore(shown);
  REQUIRE(plots.size() == 1);
  CHECK(plots[0].name == "m_front");
  const auto& chart = std::get<plots::Chart>(plots[0].content);
  REQUIRE(chart.panels.size() == 2);
  const auto points = [&](const std::string& name, std::size_t panel) {
    std::vector<std::pair<double, double>> found;
    for (const plots::Series& series : chart.series) {
      if (series.name != name || series.panel != panel) continue;
      for (const plots::Point& point : series.points) found.emplace_back(point.x, point.y);
    }
    return found;
  };
  using Points = std::vector<std::pair<double, double>>;
  // d is faster and smaller than b, but has more wrong pixels; a beats c.
  CHECK(points("Pareto front", 0) == Points{{100, 100}, {50, 200}, {25, 150}});
  CHECK(points("dominated", 0) == Points{{200, 300}});
  CHECK(points("front of the two axes", 0) == Points{{25, 150}, {100, 100}});
  CHECK(points("front of the two axes", 1) == Points{{25, 9}, {50, 4}, {100, 0}});
  CHECK(points("knee", 0).size() == 1);
  CHECK(points("knee", 1).size() == 1);
}