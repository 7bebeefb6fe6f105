#include "sim/studies/advise/show.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>
#include <vector>

#include "hw/base/text.h"
#include "sim/observe/bound.h"
#include "sim/session/options/numbers.h"
#include "sim/studies/design/axes.h"
#include "sim/studies/rows_json.h"

namespace csgsim::studies {

namespace {
/// The rows with enough colour bits.
std::vector<AdviceRow> coloured(std::span<const AdviceRow> rows, const Requirements& requirements) {
  std::vector<AdviceRow> all;
  for (const AdviceRow& row : rows) {
    if (row.is_compiled() && miss(row, Requirement::colour, requirements) == 0) all.push_back(row);
  }
  return all;
}

/// Maximum number of printed rows of the front; the files have all.
constexpr std::size_t max_rows = 40;

std::string figures_text(const AdviceRow& row) {
  const auto text = [&](Requirement requirement) { return kind_of(requirement).value_text(row); };
  return fmt::format("{}, {}, {}, {} clocks, {}", text(Requirement::bits), text(Requirement::wrong_pixels),
                     text(Requirement::speed), grouped(row.clocks), text(Requirement::colour));
}

/// Rows of the front with enough colour bits; all rows if none has.
std::vector<AdviceRow> with_colours(const std::vector<AdviceRow>& front, const Requirements& requirements) {
  std::vector<AdviceRow> all = coloured(front, requirements);
  return all.empty() ? front : all;
}

std::string colours_text(const Requirements& requirements) {
  return fmt::format(", with {} of colour or more", session::count_text(requirements.min_colour_bits, "bit"));
}

void print_row(const AdviceRow& row, bool has_alu, bool meets) {
  const DesignPoint& point = row.point;
  fmt::print("{:>5}{:>5}{:>6}{:>8}{:>7}  {:<10}{:<13}", row.used_bits, point.z_bits, point.fraction_bits,
             point.colour_bits, row.colour_error, strategy_name(point), point.colouring);
  if (has_alu) fmt::print("{:>4}", point.alu_bits);
  fmt::print("{:>12}{:>10}{:>9}{}\n", grouped(row.clocks), observe::rate_text(row.frames_per_second),
             grouped(row.wrong), meets ? "  *" : "");
}

/// Prints the first recommendation together with those that recommend the same choice.
void print_recommendation(std::span<const Recommendation> all, const std::string& command,
                          const Requirements& requirements) {
  const Recommendation& first = all.front();
  const RequirementKind& kind = kind_of(first.requirement);
  std::string names;
  for (const Recommendation& one : all) {
    if (one.row == first.row) names += fmt::format("{}{}", names.empty() ? "" : ", ", kind_of(one.requirement).best);
  }
  fmt::print("\n{}: {}\n", names, figures_text(first.row));
  if (first.miss > 0)
    fmt::print("  conflicting requirement: {}; with the others met, the best is {}, {}\n",
               kind.limit_text(requirements), kind.value_text(first.row), kind.miss_text(first.miss));
  fmt::print("  {}\n", command);
}

struct Step {
  std::uint32_t bits = 0;
  double fps = 0;

  bool operator==(const Step&) const = default;
};

struct Staircase {
  std::uint64_t max_wrong = 0;
  std::vector<Step> steps;
};

/// The accepted number of wrong pixels, 0, and 10 and 100 times the accepted number.
std::set<std::uint64_t> limits_of(const Requirements& requirements) {
  const std::uint64_t requirement = std::max<std::uint64_t>(requirements.max_wrong_pixels, 1);
  return {0, requirements.max_wrong_pixels, 10 * requirement, 100 * requirement};
}

/// The maximum frame rate with at most n bits, for each n at which it rises.
std::vector<Step> steps_of(std::span<const AdviceRow> front, std::uint64_t max_wrong) {
  std::vector<Step> steps;
  for (const AdviceRow& row : front) {
    if (row.wrong > max_wrong || (!steps.empty() && row.frames_per_second <= steps.back().fps)) continue;
    if (!steps.empty() && steps.back().bits == row.used_bits) steps.pop_back();
    steps.push_back({row.used_bits, row.frames_per_second});
  }
  return steps;
}

/// The lines of the plot, one per limit of wrong pixels; a limit with the frame rates of a stricter one has no line.
std::vector<Staircase> staircases_of(std::span<const AdviceRow> front, const Requirements& requirements) {
  std::vector<Staircase> all;
  for (const std::uint64_t limit : limits_of(requirements)) {
    std::vector<Step> steps = steps_of(front, limit);
    if (steps.empty() || (!all.empty() && all.back().steps == steps)) continue;
    all.push_back({limit, std::move(steps)});
  }
  return all;
}

std::string title_of(const Staircase& stairs) {
  if (stairs.max_wrong == 0) return "no wrong pixel";
  if (stairs.max_wrong == 1) return "at most 1 wrong pixel";
  return fmt::format("at most {} wrong pixels", stairs.max_wrong);
}

void add_staircases(const std::vector<Staircase>& all, plots::Chart& chart) {
  for (const Staircase& stairs : all) {
    plots::Series series{title_of(stairs), 0, plots::Trace::steps};
    for (const Step& step : stairs.steps) series.points.push_back({static_cast<double>(step.bits), step.fps});
    chart.series.push_back(std::move(series));
  }
}

/// Labelled marks of the recommendations; several requirements may have the same choice.
void add_recommendations(std::span<const Recommendation> all, plots::Chart& chart) {
  plots::Series series{"recommended", 0, plots::Trace::marks};
  for (const Recommendation& one : all) {
    series.points.push_back(
        {static_cast<double>(one.row.used_bits), one.row.frames_per_second, kind_of(one.requirement).best});
  }
  if (!series.points.empty()) chart.series.push_back(std::move(series));
}

void add_requirements(const Requirements& requirements, plots::Chart& chart) {
  double max_bits = 0;
  for (const plots::Series& series : chart.series) {
    for (const plots::Point& point : series.points) max_bits = std::max(max_bits, point.x);
  }
  const plots::Point requirement{static_cast<double>(requirements.max_bits), requirements.min_fps};
  if (requirement.x <= max_bits)
    chart.series.push_back(
        {fmt::format("requirement: at most {} bits", requirements.max_bits), 0, plots::Trace::upright, {requirement}});
  if (requirement.y > 0) {
    chart.series.push_back({fmt::format("requirement: at least {:g} frames/s", requirements.min_fps),
                            0,
                            plots::Trace::level,
                            {requirement}});
  }
}

using Json = nlohmann::ordered_json;

Json choice_json(const AdviceRow& row) {
  Json json;
  set_columns(json, row);
  if (row.is_compiled()) json.erase("reason");
  return json;
}

Json choices_json(std::span<const AdviceRow> rows) {
  Json json = Json::array();
  for (const AdviceRow& row : rows) json.push_back(choice_json(row));
  return json;
}

}  // namespace

std::string misses_text(const AdviceRow& row, const Requirements& requirements) {
  std::string text;
  for (const Requirement requirement : all_requirements) {
    const double by = miss(row, requirement, requirements);
    if (by > 0) text += (text.empty() ? "" : ", ") + kind_of(requirement).miss_text(by);
  }
  return text;
}

void print_search(const std::string& subject, std::span<const AdviceRow> rows, const Requirements& requirements) {
  const auto compiled = std::count_if(rows.begin(), rows.end(), [](const AdviceRow& row) { return row.is_compiled(); });
  fmt::print("{}: {} searched", printable(subject), session::count_text(rows.size(), "choice"));
  const auto refused = rows.size() - static_cast<std::size_t>(compiled);
  if (refused > 0) fmt::print("; {} cannot be drawn", grouped(refused));
  fmt::print("\nrequirements: ");
  for (const Requirement requirement : all_requirements)
    fmt::print("{}{}", requirement == Requirement::bits ? "" : ", ", kind_of(requirement).limit_text(requirements));
  fmt::print("\n");
}

void print_front(std::span<const AdviceRow> rows, const Requirements& requirements) {
  const std::vector<AdviceRow> front = with_colours(advice_front(rows), requirements);
  std::vector<AdviceRow> shown = nearest_choices(front, requirements, max_rows);
  const bool has_alu = std::any_of(shown.begin(), shown.end(), [&](const AdviceRow& row) {
    return row.point.alu_bits != shown.front().point.alu_bits;
  });
  fmt::print("\n{:>5}{:>5}{:>6}{:>8}{:>7}  {:<10}{:<13}{}{:>12}{:>10}{:>9}\n", "bits", "z", "frac.", "colour", "error",
             "strategy", "colouring", has_alu ? " ALU" : "", "clocks", "frames/s", "wrong");
  for (const AdviceRow& row : front) {
    if (std::find(shown.begin(), shown.end(), row) != shown.end())
      print_row(row, has_alu, meets_all(row, requirements));
  }
  fmt::print("*: meets all requirements. ");
  if (shown.size() < front.size())
    fmt::print("Shown are the {} closest to the requirements of {} Pareto-optimal choices{}.\n", shown.size(),
               grouped(front.size()), colours_text(requirements));
  else
    fmt::print("These are all Pareto-optimal choices{}.\n", colours_text(requirements));
}

void print_advice(const Advice& advice, const Requirements& requirements) {
  const std::span<const Recommendation> all = advice.recommendations;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (std::any_of(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(i),
                    [&](const Recommendation& other) { return other.row == all[i].row; }))
      continue;
    print_recommendation(all.subspan(i), advice.commands[i], requirements);
  }
  if (!advice.nearest) return;
  fmt::print("\nnearest: {}\n  {}\n  {}\n", figures_text(*advice.nearest), misses_text(*advice.nearest, requirements),
             advice.nearest_command);
}

std::string advice_json(const std::string& title, const Requirements& requirements, std::span<const AdviceRow> rows,
                        const Advice& advice) {
  Json recommended = Json::array();
  for (std::size_t i = 0; i < advice.recommendations.size(); ++i) {
    const Recommendation& one = advice.recommendations[i];
    recommended.push_back({{"what", kind_of(one.requirement).best},
                           {"missed_by", one.miss},
                           {"meets_all", one.miss == 0},
                           {"command", advice.commands[i]},
                           {"point", choice_json(one.row)}});
  }
  Json json{{"study", title},
            {"wishes",
             {{"max_bits", requirements.max_bits},
              {"max_wrong_pixels", requirements.max_wrong_pixels},
              {"min_fps", requirements.min_fps},
              {"min_colour_bits", requirements.min_colour_bits}}},
            {"meets_all", !advice.nearest},
            {"recommendations", recommended}};
  if (advice.nearest) json["nearest"] = {{"command", advice.nearest_command}, {"point", choice_json(*advice.nearest)}};
  json["front"] = choices_json(advice_front(rows));
  json["points"] = choices_json(rows);
  return json_file_text(json);
}

plots::Plot plot_of_advice(std::span<const AdviceRow> rows, const Requirements& requirements,
                           std::span<const Recommendation> recommendations, const std::string& model) {
  plots::Chart chart{
      fmt::format("{}: frame rate and memory, at least {} colour bits", model, requirements.min_colour_bits),
      {"memory bits per pixel", plots::Scale::linear, {}, false, true},
      {{"maximum frames/s", plots::Scale::linear}},
      {},
      "advise.csv"};
  add_staircases(staircases_of(advice_front(coloured(rows, requirements)), requirements), chart);
  if (!chart.series.empty()) {
    add_recommendations(recommendations, chart);
    add_requirements(requirements, chart);
  }
  return {"advise", std::move(chart)};
}

}  // namespace csgsim::studies
