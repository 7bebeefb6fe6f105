#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "sim/plots/common_looks.h"
#include "sim/studies/groups.h"
#include "sim/studies/sweep/show.h"

namespace csgsim::studies {

namespace {

constexpr const char* sweep_table = "sweep.csv";

plots::Axis count_axis(const char* title) { return {title, plots::Scale::by_range, {}, false, true}; }

/// Rows with the same name.
using Line = std::pair<std::string, std::vector<const SweepRow*>>;

/// A series per panel: horizontal across the panel if the line has no position on the axis.
std::vector<plots::Series> series_of(const Line& line, const SweepAxis& axis,
                                     std::span<std::uint64_t DesignRow::*const> counts) {
  const bool is_level = !axis.x_coordinate(line.second.front()->point);
  std::vector<plots::Series> all;
  for (std::size_t panel = 0; panel < counts.size(); ++panel) {
    plots::Series& series = all.emplace_back(
        plots::Series{line.first, panel, is_level ? plots::Trace::level : plots::Trace::line, {}, false});
    for (const SweepRow* row : line.second)
      series.points.push_back({axis.x_coordinate(row->point).value_or(0), static_cast<double>(row->*counts[panel])});
    if (axis.axis().is_names) series.trace = plots::Trace::marks;
    std::ranges::stable_sort(series.points, {}, &plots::Point::x);
  }
  return all;
}

bool is_same(const std::vector<plots::Series>& one, const std::vector<plots::Series>& other) {
  const auto is_same_point = [](const plots::Point& a, const plots::Point& b) { return a.x == b.x && a.y == b.y; };
  return std::ranges::equal(one, other, [&](const plots::Series& a, const plots::Series& b) {
    return a.trace == b.trace && std::ranges::equal(a.points, b.points, is_same_point);
  });
}

/// Chart of counts against the varied axis. Coinciding lines are drawn as one.
plots::Chart varied_chart(std::span<const SweepRow> rows, std::string title, std::vector<plots::Axis> panels,
                          std::span<std::uint64_t DesignRow::*const> counts) {
  const SweepAxis axis(rows);
  std::vector<std::pair<std::vector<plots::Series>, std::vector<std::string>>> drawn;
  for (const Line& line : grouped_by(rows, [&](const SweepRow& row) { return axis.other_settings(row.point); })) {
    std::vector<plots::Series> series = series_of(line, axis, counts);
    const auto same = std::ranges::find_if(drawn, [&](const auto& one) { return is_same(one.first, series); });
    if (same == drawn.end()) {
      drawn.emplace_back(std::move(series), std::vector<std::string>{line.first});
    } else {
      same->second.push_back(line.first);
    }
  }
  plots::Chart chart{std::move(title), axis.axis(), std::move(panels), {}, sweep_table};
  for (auto& [series, names] : drawn) {
    const std::string name = names.size() <= 2 ? names.front() + (names.size() == 2 ? "; " + names.back() : "")
                                               : fmt::format("{} (+ {} equal)", names.front(), names.size() - 1);
    for (plots::Series& one : series) {
      one.name = name;
      chart.series.push_back(std::move(one));
    }
  }
  return chart;
}

/// Label of points with equal results, such as `m = 7..8`.
std::string stack_bits_label(std::span<const SweepRow* const> rows) {
  const unsigned first = rows.front()->point.stack_bits;
  if (first == 0) return "";
  return rows.size() == 1 ? fmt::format("m = {}", first)
                          : fmt::format("m = {}..{}", first, rows.back()->point.stack_bits);
}

/// Maximum number of labelled lines with stack bits; more labels could not be assigned to their lines.
constexpr std::ptrdiff_t max_labelled = 3;

/// Chart of clocks against used bits, with a line per strategy and conditions.
plots::Chart bits_chart(std::span<const SweepRow> rows, const std::string& model) {
  plots::Chart chart{model + ": clocks against memory",
                     {"classification bits per pixel", plots::Scale::linear, {}, false, true},
                     {count_axis("clocks")},
                     {},
                     sweep_table};
  const PointNames names(rows);
  const std::vector<Line> lines = grouped_by(rows, [&](const SweepRow& row) {
    const std::string conditions = names.conditions(row.point);
    return row.point.strategy + (conditions.empty() ? "" : ", " + conditions);
  });
  const auto lines_with_stack_bits =
      std::ranges::count_if(lines, [](const Line& one) { return one.second.front()->point.stack_bits > 0; });
  for (const auto& [name, line] : lines) {
    plots::Series series{name, 0, plots::Trace::line, {}, false};
    for (std::size_t i = 0; i < line.size();) {
      std::size_t end = i + 1;
      while (end < line.size() && line[end]->clocks == line[i]->clocks &&
             line[end]->classification_bits == line[i]->classification_bits)
        ++end;
      series.points.push_back(
          {static_cast<double>(line[i]->classification_bits), static_cast<double>(line[i]->clocks),
           lines_with_stack_bits <= max_labelled ? stack_bits_label(std::span(line).subspan(i, end - i)) : ""});
      i = end;
    }
    if (line.size() == 1) series.trace = plots::Trace::marks;
    chart.series.push_back(std::move(series));
  }
  return chart;
}

/// The names that fit, and the number of the others.
std::string label_of(std::span<const SweepRow* const> alike, const PointNames& names) {
  constexpr std::size_t room = 36;
  std::string label = names.name(alike.front()->point);
  std::size_t named = 1;
  for (; named < alike.size(); ++named) {
    const std::string name = names.name(alike[named]->point);
    if (label.size() + name.size() >= room) break;
    label += "; " + name;
  }
  return named == alike.size() ? label : fmt::format("{} (+ {} equal)", label, alike.size() - named);
}

std::vector<plots::Tick> bit_ticks(std::uint32_t max_bit) {
  constexpr std::uint32_t max_ticks = 16;
  std::uint64_t step = 8;
  while (max_bit / step > max_ticks) step *= 2;
  std::vector<plots::Tick> ticks;
  for (std::uint64_t bit = 0; bit <= max_bit; bit += step)
    ticks.push_back({static_cast<double>(bit), std::to_string(bit)});
  return ticks;
}

/// The layout of pixel memory, with a bar for each layout among the rows.
plots::Plot memory_plot(std::span<const SweepRow> rows, const std::string& model) {
  plots::Bars plot{model + ": layout of pixel memory",
                   {"bit of pixel memory"},
                   {},
                   {"Z2", "Z1", "colour", "colour1", "mask", "product", "label", "stack", "stored", "shown"},
                   "sweep.csv"};
  std::uint32_t max_bits = 0;
  const PointNames names(rows);
  const auto layout_of = [](const SweepRow& row) {
    return std::pair(row.memory_map, row.point.memory_bits.value_or(0));
  };
  for (const auto& [layout, alike] : grouped_by(rows, layout_of)) {
    const auto& [map, bits] = layout;
    plots::Bar& bar = plot.bars.emplace_back(plots::Bar{label_of(alike, names), static_cast<double>(bits), {}});
    for (const MemoryPart& part : map)
      bar.parts.push_back({part.name, static_cast<double>(part.base), static_cast<double>(part.base) + part.width});
    max_bits = std::max(max_bits, bits);
  }
  plot.x.ticks = bit_ticks(max_bits);
  return {model + "_memory", std::move(plot)};
}

}  // namespace

std::vector<plots::Plot> plots_of_sweep(std::span<const SweepRow> rows, const std::string& model) {
  std::vector<SweepRow> compiled;
  std::ranges::copy_if(rows, std::back_inserter(compiled), &SweepRow::is_compiled);
  if (compiled.empty()) return {};
  constexpr std::array scans{&SweepRow::rendered, &SweepRow::classified};
  constexpr std::array clocks{&SweepRow::clocks};
  std::vector<plots::Plot> all{
      {model + "_scan_conversions",
       varied_chart(compiled, model + ": scan conversions of primitives",
                    {count_axis("rendered into Z1"), count_axis("classified by trees")}, scans)},
      {model + "_clocks", varied_chart(compiled, model + ": clocks", {count_axis("clocks")}, clocks)},
      {model + "_bits", bits_chart(compiled, model)},
      memory_plot(compiled, model)};
  plots::set_common_looks(all);
  return all;
}

}  // namespace csgsim::studies
