#include <algorithm>
#include <utility>

#include "sim/plots/common_looks.h"
#include "sim/studies/corpus/measure.h"
#include "sim/studies/groups.h"

namespace csgsim::studies {

namespace {

constexpr const char* corpus_table = "corpus.csv";

using Points = std::vector<plots::Point>;

/// Points with positive coordinates, as a logarithmic axis requires.
Points against_halfspaces(std::span<const CorpusRow> rows, const std::string& machine,
                          std::uint64_t CorpusRow::*clocks) {
  Points points;
  for (const CorpusRow& row : rows) {
    if (row.is_drawn() && row.point.machine == machine && row.halfspaces > 0 && row.*clocks > 0)
      points.push_back({static_cast<double>(row.halfspaces), static_cast<double>(row.*clocks)});
  }
  return points;
}

/// The share of models that are drawn at least as fast as each frame rate.
Points share_as_fast(std::span<const CorpusRow> rows, const std::string& machine) {
  std::vector<double> rates;
  for (const CorpusRow& row : rows) {
    if (row.is_drawn() && row.point.machine == machine && row.frames_per_second > 0)
      rates.push_back(row.frames_per_second);
  }
  std::ranges::sort(rates, std::ranges::greater{});
  Points points;
  points.reserve(rates.size());
  for (std::size_t i = 0; i < rates.size(); ++i)
    points.push_back({rates[i], 100.0 * static_cast<double>(i + 1) / static_cast<double>(rates.size())});
  return points;
}

/// A panel: its y axis and its points for a machine.
struct CorpusPanel {
  plots::Axis y;
  Points (*points)(std::span<const CorpusRow> rows, const std::string& machine);
};

struct CorpusPlot {
  const char* name;
  const char* title;
  plots::Axis x;
  plots::Trace trace;
  std::vector<CorpusPanel> panels;
};

std::vector<CorpusPlot> kinds_of_plot() {
  using enum plots::Scale;
  return {{"corpus_clocks",
           "Clocks per frame against half-spaces, one mark per model",
           {"half-spaces of the model", logarithmic, {}, false, true},
           plots::Trace::marks,
           {{{"clocks between frames", logarithmic, {}, false, true},
             [](std::span<const CorpusRow> rows, const std::string& machine) {
               return against_halfspaces(rows, machine, &CorpusRow::interval_clocks);
             }},
            {{"drawing clocks", logarithmic, {}, false, true},
             [](std::span<const CorpusRow> rows, const std::string& machine) {
               return against_halfspaces(rows, machine, &CorpusRow::clocks);
             }}}},
          {"corpus_frames",
           "Share of models drawn at this frame rate or faster",
           {"frames/s", logarithmic},
           plots::Trace::steps,
           {{{"share of the models that the machine draws, %", linear}, share_as_fast}}}};
}

}  // namespace

std::vector<plots::Plot> plots_of_corpus(std::span<const CorpusRow> rows) {
  std::vector<plots::Plot> all;
  for (const CorpusPlot& plot : kinds_of_plot()) {
    plots::Chart chart{plot.title, plot.x, {}, {}, corpus_table};
    for (const CorpusPanel& panel : plot.panels) {
      for (const std::string& machine : machines_of(rows)) {
        Points points = panel.points(rows, machine);
        const plots::Trace trace = points.size() > 1 ? plot.trace : plots::Trace::marks;
        if (!points.empty()) chart.series.push_back({machine, chart.panels.size(), trace, std::move(points)});
      }
      chart.panels.push_back(panel.y);
    }
    if (!chart.series.empty()) all.push_back({plot.name, std::move(chart)});
  }
  plots::set_common_looks(all);
  return all;
}

}  // namespace csgsim::studies
