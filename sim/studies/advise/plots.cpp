#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>
#include <variant>

#include "sim/studies/advise/show.h"

namespace csgsim::studies {

namespace {

struct Step {
  std::uint32_t bits = 0;
  double fps = 0;

  bool operator==(const Step&) const = default;
};

struct Staircase {
  std::uint64_t most_wrong = 0;
  std::vector<Step> steps;
};

/// The wish, none at all, and what ten and a hundred times as many would buy.
std::set<std::uint64_t> limits_of(const Wishes& wishes) {
  const std::uint64_t wish = std::max<std::uint64_t>(wishes.max_wrong_pixels, 1);
  return {0, wishes.max_wrong_pixels, 10 * wish, 100 * wish};
}

/// The most frames a second with so many bits or fewer, where that becomes more.
std::vector<Step> steps_of(std::span<const AdviceRow> front, std::uint64_t most_wrong) {
  std::vector<Step> steps;
  for (const AdviceRow& row : front) {
    if (row.wrong > most_wrong || (!steps.empty() && row.frames_per_second <= steps.back().fps)) continue;
    if (!steps.empty() && steps.back().bits == row.used_bits) steps.pop_back();
    steps.push_back({row.used_bits, row.frames_per_second});
  }
  return steps;
}

/// A limit that buys no more than a stricter one has no line.
std::vector<Staircase> staircases_of(std::span<const AdviceRow> front, const Wishes& wishes) {
  std::vector<Staircase> all;
  for (const std::uint64_t limit : limits_of(wishes)) {
    std::vector<Step> steps = steps_of(front, limit);
    if (steps.empty() || (!all.empty() && all.back().steps == steps)) continue;
    all.push_back({limit, std::move(steps)});
  }
  return all;
}

std::string title_of(const Staircase& stairs) {
  if (stairs.most_wrong == 0) return "no wrong pixel";
  if (stairs.most_wrong == 1) return "at most 1 wrong pixel";
  return fmt::format("at most {} wrong pixels", stairs.most_wrong);
}

void add_staircases(const std::vector<Staircase>& all, plots::Chart& chart) {
  for (const Staircase& stairs : all) {
    plots::Series series{title_of(stairs), 0, plots::Trace::steps};
    for (const Step& step : stairs.steps) series.points.push_back({static_cast<double>(step.bits), step.fps});
    chart.series.push_back(std::move(series));
  }
}

/// Labelled marks, one for each choice: several wishes may have the same.
void add_recommendations(std::span<const Recommendation> all, plots::Chart& chart) {
  plots::Series series{"recommended", 0, plots::Trace::marks};
  for (const Recommendation& one : all) {
    series.points.push_back(
        {static_cast<double>(one.row.used_bits), one.row.frames_per_second, recommendation_name(one.wish)});
  }
  if (!series.points.empty()) chart.series.push_back(std::move(series));
}

void add_wishes(const Wishes& wishes, plots::Chart& chart) {
  double most_bits = 0;
  for (const plots::Series& series : chart.series) {
    for (const plots::Point& point : series.points) most_bits = std::max(most_bits, point.x);
  }
  const plots::Point wish{static_cast<double>(wishes.max_bits), wishes.min_fps};
  if (wish.x <= most_bits)
    chart.series.push_back({fmt::format("wish: at most {} bits", wishes.max_bits), 0, plots::Trace::upright, {wish}});
  if (wish.y > 0) {
    chart.series.push_back(
        {fmt::format("wish: at least {:g} frames a second", wishes.min_fps), 0, plots::Trace::level, {wish}});
  }
}

/// Those with colours enough.
std::vector<AdviceRow> coloured(std::span<const AdviceRow> rows, const Wishes& wishes) {
  std::vector<AdviceRow> all;
  for (const AdviceRow& row : rows) {
    if (row.compiled() && row.point.colour_bits >= wishes.min_colour_bits) all.push_back(row);
  }
  return all;
}

}  // namespace

plots::Plot plot_of_advice(std::span<const AdviceRow> rows, const Wishes& wishes,
                           std::span<const Recommendation> recommendations, const std::string& model) {
  plots::Chart chart{fmt::format("{}: what memory buys, with {} bits of colour or more", model, wishes.min_colour_bits),
                     {"memory bits a pixel", plots::Scale::linear, {}, false, true},
                     {{"frames a second, at most", plots::Scale::linear}},
                     {},
                     "advise.csv"};
  add_staircases(staircases_of(advice_front(coloured(rows, wishes)), wishes), chart);
  if (!chart.series.empty()) {
    add_recommendations(recommendations, chart);
    add_wishes(wishes, chart);
  }
  return {"advise", std::move(chart)};
}

}  // namespace csgsim::studies
