#include "sim/studies/advise/advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "sim/observe/bound.h"
#include "sim/session/options/numbers.h"
#include "sim/studies/design/front.h"

namespace csgsim::studies {

namespace {

using session::count_text;

std::string missed_text(double by, const char* unit, const char* behind) {
  return count_text(static_cast<std::uint64_t>(by), unit) + behind;
}

/// Indexed by Requirement. A missed frame rate is rounded up in the last digit, so that it never appears as 0.
constexpr RequirementKind kinds[] = {
    {"fewest bits", "max_bits", "memory bits per pixel, maximum", false,
     [](const Requirements& requirements) { return static_cast<double>(requirements.max_bits); },
     [](const DesignRow& row) { return static_cast<double>(row.used_bits); },
     [](const Requirements& requirements) {
       return fmt::format("at most {} per pixel", count_text(requirements.max_bits, "bit"));
     },
     [](const DesignRow& row) { return fmt::format("{} per pixel", count_text(row.used_bits, "bit")); },
     [](double by) { return missed_text(by, "bit", " too many"); }},
    {"most accurate", "max_wrong_pixels", "wrong pixels, maximum", false,
     [](const Requirements& requirements) { return static_cast<double>(requirements.max_wrong_pixels); },
     [](const DesignRow& row) { return static_cast<double>(row.wrong); },
     [](const Requirements& requirements) {
       return "at most " + count_text(requirements.max_wrong_pixels, "wrong pixel");
     },
     [](const DesignRow& row) { return count_text(row.wrong, "wrong pixel"); },
     [](double by) { return missed_text(by, "wrong pixel", " too many"); }},
    {"fastest", "min_fps", "frames/s, minimum", true,
     [](const Requirements& requirements) { return requirements.min_fps; },
     [](const DesignRow& row) { return row.frames_per_second; },
     [](const Requirements& requirements) {
       return requirements.min_fps > 0 ? fmt::format("at least {:g} frames/s", requirements.min_fps) : "any speed";
     },
     [](const DesignRow& row) { return observe::rate_text(row.frames_per_second) + " frames/s"; },
     [](double by) { return fmt::format("{:.2f} frames/s too few", std::ceil(by * 100.0) / 100.0); }},
    {"most colours", "min_colour_bits", "colour bits, minimum", true,
     [](const Requirements& requirements) { return static_cast<double>(requirements.min_colour_bits); },
     [](const DesignRow& row) { return static_cast<double>(row.point.colour_bits); },
     [](const Requirements& requirements) {
       return fmt::format("at least {} of colour", count_text(requirements.min_colour_bits, "bit"));
     },
     [](const DesignRow& row) { return fmt::format("{} of colour", count_text(row.point.colour_bits, "bit")); },
     [](double by) { return missed_text(by, "bit", " of colour too few"); }},
};

/// Order of ties: cheaper hardware, then faster, then more accurate. Programs with the same time between frames may
/// take different times to draw.
Values cost(const AdviceRow& row) {
  return {static_cast<double>(row.used_bits),       static_cast<double>(row.point.alu_bits),
          static_cast<double>(row.interval_clocks), static_cast<double>(row.clocks),
          static_cast<double>(row.wrong),           -static_cast<double>(row.point.colour_bits)};
}

/// Order of choices by one requirement.
Values rank(Requirement requirement, const AdviceRow& row) {
  Values values = cost(row);
  // Speed is the time between frames, then the drawing time; `cost` breaks ties.
  if (requirement == Requirement::speed) values.insert(values.begin(), {values[2], values[3]});
  if (requirement == Requirement::wrong_pixels) values.insert(values.begin(), values[4]);
  if (requirement == Requirement::colour) values.insert(values.begin(), values[5]);
  return values;
}

bool meets_all_but(const AdviceRow& row, Requirement but, const Requirements& requirements) {
  return std::ranges::all_of(all_requirements, [&](Requirement requirement) {
    return requirement == but || miss(row, requirement, requirements) == 0;
  });
}

std::vector<AdviceRow> compiled(std::span<const AdviceRow> rows) {
  std::vector<AdviceRow> all;
  std::ranges::copy_if(rows, std::back_inserter(all), &AdviceRow::is_compiled);
  return all;
}

/// Number of missed requirements, and the sum of their relative misses.
std::pair<int, double> distance(const AdviceRow& row, const Requirements& requirements) {
  std::pair<int, double> sum{0, 0};
  for (const Requirement requirement : all_requirements) {
    const double by = miss(row, requirement, requirements);
    if (by == 0) continue;
    ++sum.first;
    sum.second += by / std::max(1.0, kind_of(requirement).limit(requirements));
  }
  return sum;
}

}  // namespace

const RequirementKind& kind_of(Requirement requirement) { return kinds[static_cast<std::size_t>(requirement)]; }

double miss(const AdviceRow& row, Requirement requirement, const Requirements& requirements) {
  const RequirementKind& kind = kind_of(requirement);
  const double over = kind.value(row) - kind.limit(requirements);
  return std::max(0.0, kind.is_minimum ? -over : over);
}

bool meets_all(const AdviceRow& row, const Requirements& requirements) {
  return std::ranges::all_of(all_requirements,
                             [&](Requirement requirement) { return miss(row, requirement, requirements) == 0; });
}

std::vector<AdviceRow> advice_front(std::span<const AdviceRow> rows) {
  const std::vector<AdviceRow> choices = compiled(rows);
  std::map<std::pair<std::uint64_t, std::uint64_t>, double>
      paces;  // ranks of the pairs (interval, clocks), fastest first
  for (const AdviceRow& row : choices) paces[{row.interval_clocks, row.clocks}] = 0;
  double place = 0;
  for (auto& [pace, number] : paces) number = place++;
  return front_rows(std::span<const AdviceRow>(choices), [&](const AdviceRow& row) {
    const Values costs = cost(row);
    return Values{costs[0], costs[1], paces.at({row.interval_clocks, row.clocks}), costs[4], costs[5]};
  });
}

std::vector<Recommendation> recommend(std::span<const AdviceRow> rows, const Requirements& requirements) {
  std::vector<Recommendation> all;
  for (const Requirement requirement : all_requirements) {
    const AdviceRow* best = nullptr;
    for (const AdviceRow& row : rows) {
      if (!row.is_compiled() || !meets_all_but(row, requirement, requirements)) continue;
      if (best == nullptr || rank(requirement, row) < rank(requirement, *best)) best = &row;
    }
    if (best != nullptr) all.push_back({requirement, *best, miss(*best, requirement, requirements)});
  }
  return all;
}

std::vector<AdviceRow> nearest_choices(std::span<const AdviceRow> rows, const Requirements& requirements,
                                       std::size_t max_count) {
  std::vector<AdviceRow> nearest = compiled(rows);
  std::ranges::stable_sort(nearest, {},
                           [&](const AdviceRow& row) { return std::pair(distance(row, requirements), cost(row)); });
  nearest.resize(std::min(max_count, nearest.size()));
  return nearest;
}

}  // namespace csgsim::studies
