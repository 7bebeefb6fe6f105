#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "sim/studies/sweep/axis.h"
#include "sim/studies/sweep/show.h"

namespace csgsim::studies {

namespace {

/// Points that lay out memory alike.
struct Layout {
  std::vector<std::string> names;
  MemoryMap map;
  std::uint32_t memory_bits = 0;
};

std::vector<Layout> layouts_of(std::span<const SweepRow> rows) {
  const PointNames names(rows);
  std::vector<Layout> layouts;
  for (const SweepRow& row : rows) {
    if (!row.compiled()) continue;
    const auto same = std::ranges::find_if(layouts, [&](const Layout& layout) {
      return layout.map == row.memory_map && layout.memory_bits == row.point.memory_bits;
    });
    Layout& layout =
        same == layouts.end() ? layouts.emplace_back(Layout{{}, row.memory_map, row.point.memory_bits}) : *same;
    layout.names.push_back(names.name(row.point));
  }
  return layouts;
}

/// As many names as there is room for, and the number of the others.
std::string label_of(const Layout& layout) {
  constexpr std::size_t room = 36;
  std::string label = layout.names.front();
  std::size_t said = 1;
  for (; said < layout.names.size() && label.size() + layout.names[said].size() < room; ++said)
    label += "; " + layout.names[said];
  return said == layout.names.size() ? label : fmt::format("{} (+ {} alike)", label, layout.names.size() - said);
}

std::vector<plots::Tick> bit_ticks(std::uint32_t most) {
  constexpr std::uint32_t most_ticks = 16;
  std::uint64_t step = 8;
  while (most / step > most_ticks) step *= 2;
  std::vector<plots::Tick> ticks;
  for (std::uint64_t bit = 0; bit <= most; bit += step)
    ticks.push_back({static_cast<double>(bit), std::to_string(bit)});
  return ticks;
}

}  // namespace

plots::Plot memory_plot(std::span<const SweepRow> rows, const std::string& model) {
  plots::Bars plot{model + ": which bits hold what",
                   {"bit of pixel memory"},
                   {},
                   {"Z2", "Z1", "colour", "colour1", "mask", "product", "label", "stack", "stored", "shown"},
                   "sweep.csv"};
  std::uint32_t most = 0;
  for (const Layout& layout : layouts_of(rows)) {
    plots::Bar& bar = plot.bars.emplace_back(plots::Bar{label_of(layout), static_cast<double>(layout.memory_bits), {}});
    for (const MemoryPart& part : layout.map)
      bar.parts.push_back({part.name, static_cast<double>(part.base), static_cast<double>(part.base) + part.width});
    most = std::max(most, layout.memory_bits);
  }
  plot.x.ticks = bit_ticks(most);
  return {model + "_memory", std::move(plot)};
}

}  // namespace csgsim::studies
