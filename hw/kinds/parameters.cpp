#include "hw/kinds/parameters.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "hw/base/nearest.h"
#include "hw/kinds/rows.h"

namespace csgsim::kinds {

std::string_view key_of(std::string_view change) { return change.substr(0, change.find('=')); }

bool has_parameter(const machines::Kind& kind, std::string_view key) {
  return std::ranges::any_of(kind.schema, [&](const machines::FigureSchema& figure) { return figure.key == key; });
}

bool is_parameter(std::string_view key) {
  return std::ranges::any_of(all(), [&](const machines::Kind* kind) { return has_parameter(*kind, key); });
}

std::string names_of_kinds_with(std::string_view key) {
  std::vector<std::string_view> names;
  for (const machines::Kind* kind : all()) {
    if (has_parameter(*kind, key)) names.push_back(kind->name);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string missing_parameter_text(std::string_view key, const machines::Kind& kind, std::string_view machine_name) {
  if (has_parameter(kind, key)) return "";
  std::vector<std::string_view> known;
  for (const machines::FigureSchema& figure : kind.schema) known.push_back(figure.key);
  const std::string_view near = nearest_similar(key, known);
  return fmt::format("{} has no such parameter, but machines of the kind {} do; {}", machine_name,
                     names_of_kinds_with(key),
                     near.empty() ? "choose one of them with --machine" : fmt::format("did you mean {}?", near));
}

}  // namespace csgsim::kinds
