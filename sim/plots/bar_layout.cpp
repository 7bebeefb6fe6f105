#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "sim/plots/axes.h"
#include "sim/plots/key.h"
#include "sim/plots/layout.h"
#include "sim/plots/text_size.h"
#include "sim/plots/tips.h"

namespace csgsim::plots {

namespace {

constexpr double bar_height = 22;
constexpr double row_height = 30;
constexpr double longest_name = 260;

std::string_view fill_of(const std::vector<std::string>& names, const std::string& name) {
  const auto number = static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
  return number < palette::fills.size() ? palette::fills[number] : palette::background.colour;
}

/// The plot's own names, followed by other names that its bars use.
std::vector<std::string> names_of(const Bars& plot) {
  std::vector<std::string> names = plot.names;
  for (const Bar& bar : plot.bars) {
    for (const Part& part : bar.parts) {
      if (std::ranges::find(names, part.name) == names.end()) names.push_back(part.name);
    }
  }
  return names;
}

bool is_used(const std::string& name, const Bars& plot) {
  return std::ranges::any_of(
      plot.bars, [&](const Bar& bar) { return std::ranges::find(bar.parts, name, &Part::name) != bar.parts.end(); });
}

std::vector<KeyEntry> key_of(const std::vector<std::string>& names, const Bars& plot) {
  std::vector<KeyEntry> key;
  std::size_t more = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!is_used(names[i], plot)) continue;
    if (i < palette::fills.size()) {
      key.push_back({names[i], Sample::fill, {palette::fills[i], "", {}}});
    } else {
      ++more;
    }
  }
  if (more > 0) {
    key.push_back({fmt::format("{} more in {}", more, plot.table), Sample::fill, {palette::background.colour, "", {}}});
  }
  if (!plot.is_signed) key.push_back({"free", Sample::fill, {palette::paper, "", {}}});
  if (plot.bars.size() > max_bars)
    key.push_back({fmt::format("{} more bars in {}", plot.bars.size() - max_bars, plot.table)});
  return key;
}

std::string part_text(const Bars& plot, const Part& part) {
  if (plot.is_signed) return fmt::format("{:+}", part.begin < 0 ? part.begin : part.end);
  return shorten(fmt::format("{} {}", part.name, part.end - part.begin), longest_name);
}

/// The range of the bars that are drawn.
Extent extent_of(std::span<const Bar> bars) {
  Extent extent{0, 1};
  for (const Bar& bar : bars) {
    extent.high = std::max(extent.high, bar.length);
    for (const Part& part : bar.parts) extent.low = std::min(extent.low, part.begin);
  }
  return extent;
}

void add_bar(Drawing& drawing, const Bars& plot, const Bar& bar, const std::vector<std::string>& names,
             const Extent& extent, const Box& row) {
  const auto x = [&](double value) { return row.left + extent.fraction_along(value) * (row.right - row.left); };
  drawing.fills.push_back({{x(0), row.top, x(bar.length), row.bottom}, palette::paper});
  for (const Part& part : bar.parts) {
    const Box box{x(part.begin), row.top, x(part.end), row.bottom};
    const std::string_view colour = fill_of(names, part.name);
    drawing.fills.push_back({box, colour, tip_text(plot, bar, part)});
    const std::string text = part_text(plot, part);
    if (text_width(text) + 4 <= box.right - box.left) {
      drawing.texts.push_back({text,
                               {(box.left + box.right) / 2, (row.top + row.bottom) / 2},
                               Anchor::centre,
                               false,
                               palette::readable_text_colour(colour)});
    }
  }
}

}  // namespace

Drawing lay_out(const Bars& plot) {
  Drawing drawing{plot_width, 0, {}, {}, {}, {}};
  const std::size_t count = std::min(plot.bars.size(), max_bars);
  std::vector<std::string> labels;
  for (std::size_t i = 0; i < count; ++i) labels.push_back(plot.bars[i].name);
  labels = shorten(labels, longest_name);
  double widest = 0;
  for (const std::string& label : labels) widest = std::max(widest, text_width(label));
  const Box area{widest + 20, title_height, plot_width - right_margin,
                 title_height + row_height * static_cast<double>(std::max<std::size_t>(count, 1))};
  const Extent extent = extent_of(std::span(plot.bars).first(count));
  const std::vector<std::string> names = names_of(plot);
  add_title(drawing, plot.title);
  for (std::size_t i = 0; i < count; ++i) {
    const double middle = area.top + row_height * (static_cast<double>(i) + 0.5);
    add_bar(drawing, plot, plot.bars[i], names, extent,
            {area.left, middle - bar_height / 2, area.right, middle + bar_height / 2});
    drawing.texts.push_back({labels[i], {area.left - 8, middle}, Anchor::right});
  }
  if (plot.is_signed) {
    const double zero = area.left + extent.fraction_along(0) * (area.right - area.left);
    drawing.lines.push_back({{{zero, area.top}, {zero, area.bottom}}, palette::ink});
  }
  const double bottom = add_x_axis(drawing, plot.x, extent, area);
  drawing.height = add_key(drawing, key_of(names, plot), side_margin, plot_width - side_margin, bottom) + side_margin;
  return drawing;
}

}  // namespace csgsim::plots
