#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "sim/study/corpus.h"
#include "sim/study/gnuplot.h"

namespace csgsim::study {

namespace {

using Marks = std::vector<std::pair<double, double>>;

/// Marks of a machine that a logarithmic axis can show.
Marks clocks_against_halfspaces(std::span<const CorpusRow> rows, const std::string& machine) {
  Marks marks;
  for (const CorpusRow& row : rows) {
    if (row.drawn() && row.point.machine == machine && row.halfspaces > 0 && row.clocks > 0)
      marks.emplace_back(row.halfspaces, row.clocks);
  }
  return marks;
}

/// At a frame rate the share of the models that are drawn at least as fast.
Marks share_as_fast(std::span<const CorpusRow> rows, const std::string& machine) {
  std::vector<double> rates;
  for (const CorpusRow& row : rows) {
    if (row.drawn() && row.point.machine == machine && row.frames_per_second > 0)
      rates.push_back(row.frames_per_second);
  }
  std::ranges::sort(rates, std::ranges::greater{});
  Marks marks;
  for (std::size_t i = 0; i < rates.size(); ++i)
    marks.emplace_back(rates[i], 100.0 * static_cast<double>(i + 1) / static_cast<double>(rates.size()));
  return marks;
}

struct CorpusPlot {
  const char* name;
  const char* axes;  ///< a script
  const char* style;
  Marks (*marks)(std::span<const CorpusRow> rows, const std::string& machine);
};

constexpr CorpusPlot plots[] = {
    {"corpus_clocks",
     "set title 'Clocks of a frame against half-spaces, a mark a model'\nset xlabel 'half-spaces of the model'\n"
     "set ylabel 'clocks'\nset logscale xy\n",
     "points ps 1", clocks_against_halfspaces},
    {"corpus_frames",
     "set title 'How many of the models are drawn at least as fast'\nset xlabel 'frames a second'\n"
     "set ylabel 'share of the models, %'\nset logscale x\nset yrange [0:105]\n",
     "steps lw 2", share_as_fast},
};

/// Empty where nothing is to be shown.
std::string script_of(std::span<const CorpusRow> rows, const CorpusPlot& plot) {
  std::string data;
  std::string series;
  unsigned index = 0;
  for (const std::string& machine : machines_of(rows)) {
    ++index;
    const Marks marks = plot.marks(rows, machine);
    if (marks.empty()) continue;
    data += fmt::format("$m{} << EOD\n", index);
    for (const auto& [x, y] : marks) data += fmt::format("{} {}\n", x, y);
    data += "EOD\n";
    series += fmt::format("{}$m{} using 1:2 with {} lt {}{} title {} noenhanced", series.empty() ? "plot " : ", ",
                          index, plot.style, index, plot.style[0] == 'p' ? fmt::format(" pt {}", 3 + 2 * index) : "",
                          plot_text(machine));
  }
  if (series.empty()) return {};
  return fmt::format("set grid\nset key outside right top\n{}{}{}\n", plot.axes, data, series);
}

}  // namespace

std::vector<std::filesystem::path> draw_corpus(std::span<const CorpusRow> rows, const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const CorpusPlot& plot : plots) {
    const std::string script = script_of(rows, plot);
    if (script.empty()) continue;
    for (std::filesystem::path& file : draw_plot(folder, plot.name, script, {960, 520}))
      files.push_back(std::move(file));
  }
  return files;
}

}  // namespace csgsim::study
