#include "sim/studies/advise/advice.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <tuple>
#include <utility>

#include "sim/studies/dimensions.h"

namespace csgsim::studies {

namespace {

/// Less is faster. Programs that take as long from frame to frame may be drawn in different times.
auto pace(const AdviceRow& row) { return std::tie(row.interval_clocks, row.clocks); }

unsigned colour_loss(const AdviceRow& row) { return std::numeric_limits<unsigned>::max() - row.point.colour_bits; }

/// Is the first nowhere worse?
bool covers(const AdviceRow& a, const AdviceRow& b) {
  return a.used_bits <= b.used_bits && a.wrong <= b.wrong && colour_loss(a) <= colour_loss(b) &&
         a.point.alu_bits <= b.point.alu_bits && pace(a) <= pace(b);
}

/// The order of equals: what is cheaper to build, then what is faster, then what is more right.
auto cost(const AdviceRow& row) {
  return std::tuple(row.used_bits, row.point.alu_bits, row.interval_clocks, row.clocks, row.wrong, colour_loss(row));
}

bool is_better(Wish wish, const AdviceRow& a, const AdviceRow& b) {
  switch (wish) {
    case Wish::bits: return cost(a) < cost(b);
    case Wish::wrong_pixels: return std::tuple(a.wrong, cost(a)) < std::tuple(b.wrong, cost(b));
    case Wish::speed: return std::tuple(pace(a), cost(a)) < std::tuple(pace(b), cost(b));
    case Wish::colour: return std::tuple(colour_loss(a), cost(a)) < std::tuple(colour_loss(b), cost(b));
  }
  return false;
}

/// What is asked for.
double wished(Wish wish, const Wishes& wishes) {
  switch (wish) {
    case Wish::bits: return wishes.max_bits;
    case Wish::wrong_pixels: return static_cast<double>(wishes.max_wrong_pixels);
    case Wish::speed: return wishes.min_fps;
    case Wish::colour: return wishes.min_colour_bits;
  }
  return 0;
}

bool meets_all_but(const AdviceRow& row, Wish but, const Wishes& wishes) {
  return std::all_of(std::begin(all_wishes), std::end(all_wishes),
                     [&](Wish wish) { return wish == but || miss(row, wish, wishes) == 0; });
}

std::vector<AdviceRow> compiled(std::span<const AdviceRow> rows) {
  std::vector<AdviceRow> all;
  std::ranges::copy_if(rows, std::back_inserter(all), &AdviceRow::compiled);
  return all;
}

/// How many wishes are missed, and the sum of the parts that they are missed by.
std::pair<int, double> distance(const AdviceRow& row, const Wishes& wishes) {
  std::pair<int, double> sum{0, 0};
  for (const Wish wish : all_wishes) {
    const double by = miss(row, wish, wishes);
    if (by == 0) continue;
    ++sum.first;
    sum.second += by / std::max(1.0, wished(wish, wishes));
  }
  return sum;
}

}  // namespace

std::vector<AdvicePoint> points_of(const AdviceRanges& ranges) {
  std::vector<AdvicePoint> points;
  for (const unsigned z_bits : ranges.z_bits) {
    for (const unsigned fraction_bits : ranges.fraction_bits) {
      for (const unsigned colour_bits : ranges.colour_bits) {
        for (const std::string& colouring : ranges.colourings) {
          for_each_strategy(ranges, AdvicePoint{z_bits, fraction_bits, colour_bits, colouring, {}, 0, 0},
                            [&](AdvicePoint point) {
                              for (const unsigned alu_bits : ranges.alu_bits) {
                                point.alu_bits = alu_bits;
                                points.push_back(point);
                              }
                            });
        }
      }
    }
  }
  return points;
}

std::string strategy_name(const AdvicePoint& point) { return strategy_name(point.strategy, point.stack_bits); }

double miss(const AdviceRow& row, Wish wish, const Wishes& wishes) {
  const double limit = wished(wish, wishes);
  switch (wish) {
    case Wish::bits: return std::max(0.0, static_cast<double>(row.used_bits) - limit);
    case Wish::wrong_pixels: return std::max(0.0, static_cast<double>(row.wrong) - limit);
    case Wish::speed: return std::max(0.0, limit - row.frames_per_second);
    case Wish::colour: return std::max(0.0, limit - static_cast<double>(row.point.colour_bits));
  }
  return 0;
}

bool meets_all(const AdviceRow& row, const Wishes& wishes) {
  return std::all_of(std::begin(all_wishes), std::end(all_wishes),
                     [&](Wish wish) { return miss(row, wish, wishes) == 0; });
}

std::vector<AdviceRow> advice_front(std::span<const AdviceRow> rows) {
  std::vector<AdviceRow> sorted = compiled(rows);
  std::ranges::stable_sort(sorted, {}, cost);  // what beats another comes before it then
  std::vector<AdviceRow> front;
  for (AdviceRow& row : sorted) {
    if (std::ranges::none_of(front, [&](const AdviceRow& one) { return covers(one, row); }))
      front.push_back(std::move(row));
  }
  return front;
}

std::vector<Recommendation> recommend(std::span<const AdviceRow> rows, const Wishes& wishes) {
  std::vector<Recommendation> all;
  for (const Wish wish : all_wishes) {
    const AdviceRow* best = nullptr;
    for (const AdviceRow& row : rows) {
      if (!row.compiled() || !meets_all_but(row, wish, wishes)) continue;
      if (best == nullptr || is_better(wish, row, *best)) best = &row;
    }
    if (best != nullptr) all.push_back({wish, *best, miss(*best, wish, wishes)});
  }
  return all;
}

std::string recommendation_name(Wish wish) {
  switch (wish) {
    case Wish::bits: return "fewest bits";
    case Wish::wrong_pixels: return "most accurate";
    case Wish::speed: return "fastest";
    case Wish::colour: return "most colours";
  }
  return {};
}

std::vector<AdviceRow> nearest_choices(std::span<const AdviceRow> rows, const Wishes& wishes, std::size_t most) {
  std::vector<AdviceRow> nearest = compiled(rows);
  std::ranges::stable_sort(nearest, {},
                           [&](const AdviceRow& row) { return std::tuple(distance(row, wishes), cost(row)); });
  nearest.resize(std::min(most, nearest.size()));
  return nearest;
}

}  // namespace csgsim::studies
