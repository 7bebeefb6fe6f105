#include "hw/machines/names.h"

#include <fmt/format.h>

#include <algorithm>

namespace csgsim::machines {

namespace {

constexpr std::string_view file_ending = ".toml";

}  // namespace

std::string_view file_of(std::string_view spec) {
  if (spec.ends_with(file_ending)) return spec;
  const std::size_t end = spec.rfind(std::string(file_ending) + "+");
  return end == spec.npos ? std::string_view() : spec.substr(0, end + file_ending.size());
}

std::string_view base_name(std::string_view spec) {
  const std::string_view file = file_of(spec);
  return file.empty() ? spec.substr(0, spec.find('+')) : file;
}

std::vector<std::string> changes_of(std::string_view spec) {
  std::string_view rest = spec.substr(base_name(spec).size());
  std::vector<std::string> changes;
  while (!rest.empty()) {
    rest.remove_prefix(1);
    const std::size_t end = std::min(rest.find('+'), rest.size());
    changes.emplace_back(rest.substr(0, end));
    rest.remove_prefix(end);
  }
  return changes;
}

std::string edits_suffix(std::span<const Figure> figures, std::span<const Figure> original_figures) {
  std::string name;
  for (const Figure& figure : original_figures) {
    const auto found = std::ranges::find(figures, figure.key, &Figure::key);
    if (found->value != figure.value) name += fmt::format("+{}={}", found->key, found->value);
  }
  return name;
}

}  // namespace csgsim::machines
