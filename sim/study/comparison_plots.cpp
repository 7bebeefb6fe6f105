#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "sim/study/comparison.h"
#include "sim/study/gnuplot.h"

namespace csgsim::study {

namespace {

/// One plot: which rows it shows, and against what.
struct View {
  const char* name;
  const char* title;
  bool (*shows)(const ComparisonRow& row, const machines::Size& base);
  double (*against)(const ComparisonRow& row);
};

constexpr View views[] = {
    {"halfspaces", "half-spaces of the model",
     [](const ComparisonRow& row, const machines::Size& base) {
       return machines::Size{row.point.width, row.point.height} == base;
     },
     [](const ComparisonRow& row) { return static_cast<double>(row.halfspaces); }},
    {"pixels", "pixels of the picture",
     [](const ComparisonRow& row, const machines::Size& /*base*/) { return row.point.fragments == 0; },
     [](const ComparisonRow& row) { return static_cast<double>(row.point.width) * row.point.height; }},
};

std::vector<std::string> machines_of(std::span<const ComparisonRow> rows) {
  std::vector<std::string> names;
  for (const ComparisonRow& row : rows) {
    if (std::find(names.begin(), names.end(), row.point.machine) == names.end()) names.push_back(row.point.machine);
  }
  return names;
}

struct Point {
  double x = 0;
  double y = 0;
};

std::vector<Point> line_of(std::span<const ComparisonRow> rows, const std::string& machine, const View& view,
                           const machines::Size& base) {
  std::vector<Point> points;
  for (const ComparisonRow& row : rows) {
    if (row.drawn() && row.point.machine == machine && view.shows(row, base))
      points.push_back({view.against(row), row.seconds * 1e3});
  }
  std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
  return points;
}

/// Empty where no line would have more than one point.
std::string script_of(std::span<const ComparisonRow> rows, const View& view, const machines::Size& base,
                      const std::string& model) {
  std::string data;
  std::string plots;
  bool varies = false;
  double least = std::numeric_limits<double>::max();
  double most = 0;
  for (const std::string& machine : machines_of(rows)) {
    const std::vector<Point> line = line_of(rows, machine, view, base);
    if (line.empty()) continue;
    varies = varies || line.front().x < line.back().x;
    const std::string name = fmt::format("$m{}", data.size());
    data += name + " << EOD\n";
    for (const Point& point : line) {
      data += fmt::format("{} {}\n", point.x, point.y);
      least = std::min(least, point.y);
      most = std::max(most, point.y);
    }
    data += "EOD\n";
    plots += fmt::format("{}{} using 1:2 with linespoints pt 7 lw 2 title {} noenhanced",
                         plots.empty() ? "plot " : ", ", name, plot_text(machine));
  }
  if (!varies) return {};
  return fmt::format(
      "set title {} noenhanced\nset xlabel '{}'\nset ylabel 'time of a frame, ms'\nset logscale xy\nset grid\n"
      "set key outside bottom horizontal\nset yrange [{}:{}]\nset offsets graph 0.05, graph 0.05, 0, 0\n{}{}\n",
      plot_text(fmt::format("{}: machines against {}", model, view.title)), view.title, least / 1.5, most * 1.5, data,
      plots);
}

}  // namespace

std::vector<std::filesystem::path> draw_comparison(std::span<const ComparisonRow> rows, const machines::Size& base,
                                                   const std::string& model, const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const View& view : views) {
    const std::string script = script_of(rows, view, base, model);
    if (script.empty()) continue;
    for (std::filesystem::path& file : draw_plot(folder, std::string("compare_") + view.name, script))
      files.push_back(std::move(file));
  }
  return files;
}

}  // namespace csgsim::study
