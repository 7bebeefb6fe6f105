#include "sim/study/memory_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "sim/study/gnuplot.h"

namespace csgsim::study {

namespace {

/// Points that lay out memory alike.
struct Bar {
  std::string label;
  MemoryMap map;
  std::uint32_t memory_bits = 0;
};

std::vector<Bar> bars_of(std::span<const SweepRow> rows) {
  const PointNames names(rows);
  std::vector<Bar> bars;
  for (const SweepRow& row : rows) {
    if (!row.compiled()) continue;
    const auto same = std::find_if(bars.begin(), bars.end(), [&](const Bar& bar) {
      return bar.map == row.memory_map && bar.memory_bits == row.point.memory_bits;
    });
    if (same == bars.end()) {
      bars.push_back({names.name(row.point), row.memory_map, row.point.memory_bits});
    } else if (same->label.size() < 40) {
      same->label += "; " + names.name(row.point);
    } else if (!same->label.ends_with("...")) {
      same->label += " ...";
    }
  }
  return bars;
}

/// What each part of memory is painted with, in the order of the key.
constexpr std::pair<const char*, const char*> part_colours[] = {
    {"Z2", "#4477aa"},   {"Z1", "#88bbdd"},      {"colour", "#cc8844"}, {"colour1", "#eebb88"},
    {"mask", "#222222"}, {"product", "#aa3377"}, {"label", "#228833"},  {"stack", "#ee6677"},
};

std::string map_script(const std::vector<Bar>& bars, const std::string& model) {
  std::string labels;
  std::string ticks;
  std::string data = "$free << EOD\n";
  for (std::size_t i = 0; i < bars.size(); ++i)
    data += fmt::format("0 0 0 {} {} {}\n", bars[i].memory_bits, static_cast<double>(i) - 0.38,
                        static_cast<double>(i) + 0.38);
  data += "EOD\n";
  std::string plots =
      "plot $free using 1:2:3:4:5:6 with boxxyerror lc rgb 'white' fs solid 1 border lc rgb 'black' title 'free'";
  for (const auto& [name, colour] : part_colours) {
    std::string boxes;
    for (std::size_t i = 0; i < bars.size(); ++i) {
      for (const MemoryPart& part : bars[i].map) {
        if (part.name != name) continue;
        const double y = static_cast<double>(i);
        boxes += fmt::format("0 0 {} {} {} {}\n", part.base, part.base + part.width, y - 0.38, y + 0.38);
        if (part.width >= 4)
          labels += fmt::format("set label '{} {}' at {},{} center front tc rgb 'white'\n", name, part.width,
                                part.base + part.width / 2.0, y);
      }
    }
    if (boxes.empty()) continue;
    data += fmt::format("${} << EOD\n{}EOD\n", name, boxes);
    plots +=
        fmt::format(", ${} using 1:2:3:4:5:6 with boxxyerror lc rgb '{}' fs solid 1 border lc rgb 'black' title '{}'",
                    name, colour, name);
  }
  for (std::size_t i = 0; i < bars.size(); ++i)
    ticks += fmt::format("{}{} {}", ticks.empty() ? "" : ", ", quoted(bars[i].label), i);
  return fmt::format(
      "set title {} noenhanced\nset xlabel 'bit of pixel memory'\nset ytics ({}) noenhanced\nset yrange [{}:-0.6]\nset "
      "xrange [0:*]\nset xtics 8 out nomirror\nset key bmargin center horizontal maxcols 5\nset bmargin 6\n{}{}{}\n",
      quoted(model + ": which bits hold what"), ticks, static_cast<double>(bars.size()) - 0.4, labels, data, plots);
}

}  // namespace

std::vector<std::filesystem::path> draw_memory(std::span<const SweepRow> rows, const std::string& model,
                                               const std::filesystem::path& folder) {
  constexpr unsigned margins = 150;
  constexpr unsigned bar_height = 28;
  const std::vector<Bar> bars = bars_of(rows);
  return draw_plot(folder, model + "_memory", map_script(bars, model),
                   {900, margins + bar_height * static_cast<unsigned>(bars.size())});
}

}  // namespace csgsim::study
