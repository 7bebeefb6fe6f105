#include "sim/study/memory_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "sim/study/gnuplot.h"

namespace csgsim::study {

namespace {

/// Points that lay out memory alike.
struct Bar {
  std::vector<std::string> names;
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
    Bar& bar = same == bars.end() ? bars.emplace_back(Bar{{}, row.memory_map, row.point.memory_bits}) : *same;
    bar.names.push_back(names.name(row.point));
  }
  return bars;
}

/// As many names as there is room for, and the number of the others.
std::string label_of(const Bar& bar) {
  constexpr std::size_t room = 36;
  std::string label = bar.names.front();
  std::size_t said = 1;
  for (; said < bar.names.size() && label.size() + bar.names[said].size() < room; ++said)
    label += "; " + bar.names[said];
  return said == bar.names.size() ? label : fmt::format("{} (+ {} alike)", label, bar.names.size() - said);
}

/// Pixels that the bars take from side to side.
constexpr unsigned bars_width = 640;

/// What each part of memory is painted with, in the order of the key.
constexpr std::pair<const char*, const char*> part_colours[] = {
    {"Z2", "#4477aa"},      {"Z1", "#88bbdd"},    {"colour", "#cc8844"}, {"colour1", "#eebb88"}, {"mask", "#222222"},
    {"product", "#aa3377"}, {"label", "#228833"}, {"stack", "#ee6677"},  {"shown", "#aa8855"},
};

std::string map_script(const std::vector<Bar>& bars, const std::string& model) {
  std::uint32_t most_bits = 1;
  for (const Bar& bar : bars) most_bits = std::max(most_bits, bar.memory_bits);
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
        const std::string label = fmt::format("{} {}", name, part.width);
        if (part.width * bars_width / most_bits >= label.size() * character_width)
          labels += fmt::format("set label '{}' at {},{} center front tc rgb 'white'\n", label,
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
    ticks += fmt::format("{}{} {}", ticks.empty() ? "" : ", ", tick_text(label_of(bars[i])), i);
  return fmt::format(
      "set title {} noenhanced\nset xlabel 'bit of pixel memory'\nset ytics ({}) noenhanced\nset yrange [{}:-0.6]\nset "
      "xrange [0:*]\nset xtics {} out nomirror\nset key bmargin center horizontal maxcols 5\nset bmargin 6\n{}{}{}\n",
      plot_text(model + ": which bits hold what"), ticks, static_cast<double>(bars.size()) - 0.4,
      most_bits <= 128 ? 8 : 32, labels, data, plots);
}

}  // namespace

std::vector<std::filesystem::path> draw_memory(std::span<const SweepRow> rows, const std::string& model,
                                               const std::filesystem::path& folder) {
  constexpr unsigned margins = 160;
  constexpr unsigned bar_height = 28;
  const std::vector<Bar> bars = bars_of(rows);
  std::size_t longest = 0;
  for (const Bar& bar : bars) longest = std::max(longest, label_of(bar).size());
  return draw_plot(folder, model + "_memory", map_script(bars, model),
                   {bars_width + 60 + character_width * static_cast<unsigned>(longest),
                    margins + bar_height * static_cast<unsigned>(bars.size())});
}

}  // namespace csgsim::study
