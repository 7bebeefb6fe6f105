#include "sim/plots/key.h"

#include <algorithm>

#include "sim/plots/text_size.h"

namespace csgsim::plots {

namespace {

constexpr double sample_width = 40;
constexpr double space = 8;     ///< pixels between a sample and its text
constexpr double columns = 24;  ///< pixels between columns

double room_before_text(const KeyEntry& entry) { return entry.sample == Sample::none ? 0 : sample_width + space; }

void add_sample(Drawing& drawing, const KeyEntry& entry, double left, double middle) {
  const palette::Look& look = entry.look;
  if (entry.sample == Sample::fill)
    drawing.fills.push_back({{left, middle - 6, left + sample_width, middle + 6}, look.colour});
  if (entry.sample == Sample::line || entry.sample == Sample::level)
    drawing.lines.push_back({{{left, middle}, {left + sample_width, middle}}, look.colour, 2, look.dash});
  if (entry.sample == Sample::line || entry.sample == Sample::mark)
    drawing.marks.push_back({{left + sample_width / 2, middle}, look.mark, look.colour});
}

}  // namespace

double add_key(Drawing& drawing, std::span<const KeyEntry> entries, double left, double right, double top) {
  if (entries.empty()) return top;
  std::vector<std::string> texts;
  texts.reserve(entries.size());
  for (const KeyEntry& entry : entries) texts.push_back(entry.text);
  texts = shorten(texts, right - left - sample_width - space);
  double widest = 0;
  for (std::size_t i = 0; i < entries.size(); ++i)
    widest = std::max(widest, room_before_text(entries[i]) + text_width(texts[i]));
  const auto fitting = static_cast<std::size_t>((right - left + columns) / (widest + columns));
  const std::size_t in_row = std::clamp<std::size_t>(fitting, 1, entries.size());
  const double from = (left + right - static_cast<double>(in_row) * (widest + columns) + columns) / 2;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const double x = from + static_cast<double>(i % in_row) * (widest + columns);
    const std::size_t row = i / in_row;
    const double y = top + (static_cast<double>(row) + 0.5) * (line_height + 2);
    add_sample(drawing, entries[i], x, y);
    drawing.texts.push_back({texts[i], {x + room_before_text(entries[i]), y}});
  }
  const std::size_t rows = (entries.size() + in_row - 1) / in_row;
  return top + static_cast<double>(rows) * (line_height + 2);
}

}  // namespace csgsim::plots
