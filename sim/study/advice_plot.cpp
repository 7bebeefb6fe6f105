#include "sim/study/advice_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "sim/study/gnuplot.h"

namespace csgsim::study {

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

struct Range {
  double low = 0;
  double high = 0;
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
    if (!steps.empty() && steps.back().bits == row.memory_bits) steps.pop_back();
    steps.push_back({row.memory_bits, row.frames_per_second});
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

Range widened(Range range) {
  const double room = std::max(1.0, (range.high - range.low) * 0.08);
  return {std::max(0.0, range.low - room), range.high + room};
}

std::string choice_title(const AdvicePoint& point) {
  std::string title = fmt::format("{}, {}, z {}, fraction {}, colour {}", strategy_name(point), point.colouring,
                                  point.z_bits, point.fraction_bits, point.colour_bits);
  if (point.alu_bits > 1) title += fmt::format(", ALU {}", point.alu_bits);
  return title;
}

/// Series of a plot with their data, in the order of the legend.
class Series {
 public:
  void add(const std::string& data, const std::string& style, const std::string& title) {
    data_ += fmt::format("$series{} << EOD\n{}EOD\n", count_, data);
    plots_ += fmt::format("{} $series{} using 1:2 {} title {} noenhanced", count_ == 0 ? "plot" : ",", count_, style,
                          plot_text(title));
    longest_ = std::max(longest_, title.size());
    ++count_;
  }

  [[nodiscard]] std::string script() const { return data_ + plots_ + "\n"; }

  /// With the legend below, a line a series.
  [[nodiscard]] PlotSize size() const {
    return {std::max(800U, 160 + character_width * static_cast<unsigned>(longest_)),
            430 + line_height * static_cast<unsigned>(count_)};
  }

 private:
  std::string data_;
  std::string plots_;
  std::size_t count_ = 0;
  std::size_t longest_ = 0;
};

void add_staircases(const std::vector<Staircase>& all, double right, Series& series) {
  // Told apart by their dashes and shades: light where little is asked.
  constexpr const char* colours[] = {"#000000", "#0072b2", "#e69f00", "#999999"};
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::string data;
    for (const Step& step : all[i].steps) data += fmt::format("{} {}\n", step.bits, step.fps);
    data += fmt::format("{} {}\n", right, all[i].steps.back().fps);
    const std::string title = all[i].most_wrong == 0   ? "no wrong pixel"
                              : all[i].most_wrong == 1 ? "at most 1 wrong pixel"
                                                       : fmt::format("at most {} wrong pixels", all[i].most_wrong);
    series.add(data, fmt::format("with steps lw 2.5 dt {} lc rgb '{}'", i + 1, colours[i % std::size(colours)]), title);
  }
}

/// Open marks of several shapes and sizes, so that those at the same place are all seen; one where several wishes
/// have the same choice.
void add_recommendations(std::span<const Recommendation> all, Series& series) {
  constexpr unsigned shapes[] = {6, 4, 8, 12};
  constexpr double sizes[] = {3.0, 2.3, 1.6, 1.0};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const AdviceRow& row = all[i].row;
    const auto is_same = [&](const Recommendation& other) { return other.row == row; };
    if (std::any_of(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(i), is_same)) continue;
    std::string names;
    for (const Recommendation& one : all.subspan(i))
      if (is_same(one)) names += (names.empty() ? "" : ", ") + recommendation_name(one.wish);
    series.add(fmt::format("{} {}\n", row.memory_bits, row.frames_per_second),
               fmt::format("with points pt {} ps {} lw 2 lc rgb '#d55e00'", shapes[i % std::size(shapes)],
                           sizes[i % std::size(sizes)]),
               names + ": " + choice_title(row.point));
  }
}

void add_wishes(const Wishes& wishes, Range x, Range y, Series& series) {
  constexpr const char* style = "with lines lw 1 dt 3 lc rgb '#009e73'";
  if (wishes.max_bits >= x.low && wishes.max_bits <= x.high)
    series.add(fmt::format("{0} {1}\n{0} {2}\n", wishes.max_bits, y.low, y.high), style,
               fmt::format("wish: at most {} bits", wishes.max_bits));
  if (wishes.min_fps > 0)
    series.add(fmt::format("{0} {2}\n{1} {2}\n", x.low, x.high, wishes.min_fps), style,
               fmt::format("wish: at least {:g} frames a second", wishes.min_fps));
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

std::vector<std::filesystem::path> draw_advice_plot(std::span<const AdviceRow> rows, const Wishes& wishes,
                                                    std::span<const Recommendation> recommendations,
                                                    const std::string& model, const std::filesystem::path& folder) {
  const std::vector<Staircase> staircases = staircases_of(advice_front(coloured(rows, wishes)), wishes);
  if (staircases.empty()) return {};
  Range bits{1e9, 0};
  Range fps{wishes.min_fps > 0 ? wishes.min_fps : 1e9, wishes.min_fps};
  const auto hold = [&](double of_bits, double of_fps) {
    bits = {std::min(bits.low, of_bits), std::max(bits.high, of_bits)};
    fps = {std::min(fps.low, of_fps), std::max(fps.high, of_fps)};
  };
  for (const Staircase& one : staircases) {
    for (const Step& step : one.steps) hold(step.bits, step.fps);
  }
  for (const Recommendation& one : recommendations) hold(one.row.memory_bits, one.row.frames_per_second);
  const Range x = widened(bits);
  const Range y = widened(fps);
  Series series;
  add_staircases(staircases, x.high, series);
  add_wishes(wishes, x, y, series);
  add_recommendations(recommendations, series);
  const std::string script = fmt::format(
      "set title {} noenhanced\nset xlabel 'memory bits a pixel'\nset ylabel 'frames a second, at most'\n"
      "set xrange [{}:{}]\nset yrange [{}:{}]\nset grid\nset key below center vertical maxcols 1 Left "
      "reverse\n",
      plot_text(fmt::format("{}: what memory buys, with {} bits of colour or more", model, wishes.min_colour_bits)),
      x.low, x.high, y.low, y.high);
  return draw_plot(folder, "advise", script + series.script(), series.size());
}

}  // namespace csgsim::study
