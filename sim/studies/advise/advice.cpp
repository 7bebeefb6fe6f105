#include "sim/studies/advise/advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "sim/session/options/numbers.h"
#include "sim/studies/design/front.h"

namespace csgsim::studies {

namespace {

using session::counted;

std::string missed_text(double by, const char* unit, const char* behind) {
  return counted(static_cast<std::uint64_t>(by), unit) + behind;
}

/// Indexed by Wish. A missed frame rate is rounded up in the last digit, so that it never appears as 0.
constexpr WishKind kinds[] = {
    {"fewest bits", "max_bits", "memory bits per pixel, maximum", false,
     [](const Wishes& wishes) { return static_cast<double>(wishes.max_bits); },
     [](const DesignRow& row) { return static_cast<double>(row.used_bits); },
     [](const Wishes& wishes) { return fmt::format("at most {} per pixel", counted(wishes.max_bits, "bit")); },
     [](const DesignRow& row) { return fmt::format("{} per pixel", counted(row.used_bits, "bit")); },
     [](double by) { return missed_text(by, "bit", " too many"); }},
    {"most accurate", "max_wrong_pixels", "wrong pixels, maximum", false,
     [](const Wishes& wishes) { return static_cast<double>(wishes.max_wrong_pixels); },
     [](const DesignRow& row) { return static_cast<double>(row.wrong); },
     [](const Wishes& wishes) { return "at most " + counted(wishes.max_wrong_pixels, "wrong pixel"); },
     [](const DesignRow& row) { return counted(row.wrong, "wrong pixel"); },
     [](double by) { return missed_text(by, "wrong pixel", " too many"); }},
    {"fastest", "min_fps", "frames/s, minimum", true, [](const Wishes& wishes) { return wishes.min_fps; },
     [](const DesignRow& row) { return row.frames_per_second; },
     [](const Wishes& wishes) {
       return wishes.min_fps > 0 ? fmt::format("at least {:g} frames/s", wishes.min_fps) : "any speed";
     },
     [](const DesignRow& row) { return fmt::format("{:.2f} frames/s", row.frames_per_second); },
     [](double by) { return fmt::format("{:.2f} frames/s too few", std::ceil(by * 100.0) / 100.0); }},
    {"most colours", "min_colour_bits", "colour bits, minimum", true,
     [](const Wishes& wishes) { return static_cast<double>(wishes.min_colour_bits); },
     [](const DesignRow& row) { return static_cast<double>(row.point.colour_bits); },
     [](const Wishes& wishes) { return fmt::format("at least {} of colour", counted(wishes.min_colour_bits, "bit")); },
     [](const DesignRow& row) { return fmt::format("{} of colour", counted(row.point.colour_bits, "bit")); },
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
Values rank(Wish wish, const AdviceRow& row) {
  Values values = cost(row);
  // Speed is the time between frames, then the drawing time; `cost` breaks ties.
  if (wish == Wish::speed) values.insert(values.begin(), {values[2], values[3]});
  if (wish == Wish::wrong_pixels) values.insert(values.begin(), values[4]);
  if (wish == Wish::colour) values.insert(values.begin(), values[5]);
  return values;
}

bool meets_all_but(const AdviceRow& row, Wish but, const Wishes& wishes) {
  return std::ranges::all_of(all_wishes, [&](Wish wish) { return wish == but || miss(row, wish, wishes) == 0; });
}

std::vector<AdviceRow> compiled(std::span<const AdviceRow> rows) {
  std::vector<AdviceRow> all;
  std::ranges::copy_if(rows, std::back_inserter(all), &AdviceRow::compiled);
  return all;
}

/// Number of missed requirements, and the sum of their relative misses.
std::pair<int, double> distance(const AdviceRow& row, const Wishes& wishes) {
  std::pair<int, double> sum{0, 0};
  for (const Wish wish : all_wishes) {
    const double by = miss(row, wish, wishes);
    if (by == 0) continue;
    ++sum.first;
    sum.second += by / std::max(1.0, kind_of(wish).limit(wishes));
  }
  return sum;
}

}  // namespace

const WishKind& kind_of(Wish wish) { return kinds[static_cast<std::size_t>(wish)]; }

double miss(const AdviceRow& row, Wish wish, const Wishes& wishes) {
  const WishKind& kind = kind_of(wish);
  const double over = kind.value(row) - kind.limit(wishes);
  return std::max(0.0, kind.is_least ? -over : over);
}

bool meets_all(const AdviceRow& row, const Wishes& wishes) {
  return std::ranges::all_of(all_wishes, [&](Wish wish) { return miss(row, wish, wishes) == 0; });
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

std::vector<Recommendation> recommend(std::span<const AdviceRow> rows, const Wishes& wishes) {
  std::vector<Recommendation> all;
  for (const Wish wish : all_wishes) {
    const AdviceRow* best = nullptr;
    for (const AdviceRow& row : rows) {
      if (!row.compiled() || !meets_all_but(row, wish, wishes)) continue;
      if (best == nullptr || rank(wish, row) < rank(wish, *best)) best = &row;
    }
    if (best != nullptr) all.push_back({wish, *best, miss(*best, wish, wishes)});
  }
  return all;
}

std::vector<AdviceRow> nearest_choices(std::span<const AdviceRow> rows, const Wishes& wishes, std::size_t most) {
  std::vector<AdviceRow> nearest = compiled(rows);
  std::ranges::stable_sort(nearest, {},
                           [&](const AdviceRow& row) { return std::pair(distance(row, wishes), cost(row)); });
  nearest.resize(std::min(most, nearest.size()));
  return nearest;
}

}  // namespace csgsim::studies
