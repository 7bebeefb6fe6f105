#include "sim/studies/sensitivity/figures.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <optional>
#include <string_view>

#include "sim/studies/design/grid.h"

namespace csgsim::studies {

namespace {

std::optional<std::int64_t> whole_number(const std::string& text) {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

}  // namespace

bool is_size_figure(std::string_view key) {
  constexpr std::string_view sizes[] = {"array.width", "array.height"};
  return key.starts_with("picture.") || is_memory_figure(key) || std::ranges::find(sizes, key) != std::end(sizes);
}

void add_ranged_figures(std::span<const machines::Figure> figures, bool is_of_process, const std::set<std::string>& but,
                        std::vector<RangedFigure>& ranged) {
  for (const machines::Figure& figure : figures) {
    if (!figure.range || figure.range->low == figure.range->high) continue;
    if (!is_of_process && (is_size_figure(figure.key) || but.contains(figure.key))) continue;
    if (const std::optional<std::int64_t> value = whole_number(figure.value))
      ranged.push_back({figure.key, figure.unit, *value, figure.range->low, figure.range->high, figure.range->reason,
                        is_of_process});
  }
}

}  // namespace csgsim::studies
