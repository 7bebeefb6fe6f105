#include "sim/studies/design/value_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "hw/base/text.h"

namespace csgsim::studies {

namespace {

/// Values from here on are printed without a fraction.
constexpr double min_rounded = 10'000;
constexpr double max_grouped = 1e15;

}  // namespace

std::string value_text(double value) {
  const bool is_shown_whole = value >= min_rounded || value == std::floor(value);
  if (value >= 0 && value < max_grouped && is_shown_whole)
    return grouped(static_cast<std::uint64_t>(std::llround(value)));
  return fmt::format("{:.4g}", value);
}

void print_cells(const std::vector<std::vector<std::string>>& lines, Align align) {
  std::vector<std::size_t> widths(lines.front().size());
  for (const std::vector<std::string>& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
  }
  if (align == Align::left) widths.back() = 0;
  for (const std::vector<std::string>& line : lines) {
    std::string text;
    for (std::size_t i = 0; i < line.size(); ++i)
      text += align == Align::left ? fmt::format("  {:<{}}", line[i], widths[i])
                                   : fmt::format("  {:>{}}", line[i], widths[i]);
    fmt::print("{}\n", text);
  }
}

}  // namespace csgsim::studies
