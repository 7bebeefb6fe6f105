#include "hw/machines/names.h"

#include <fmt/format.h>

#include <algorithm>

namespace csgsim::machines {

namespace {

constexpr std::string_view file_ending = ".toml";

}  // namespace

std::string_view file_of(std::string_view said) {
  if (said.ends_with(file_ending)) return said;
  const std::size_t end = said.rfind(std::string(file_ending) + "+");
  return end == said.npos ? std::string_view() : said.substr(0, end + file_ending.size());
}

std::string_view base_of(std::string_view said) {
  const std::string_view file = file_of(said);
  return file.empty() ? said.substr(0, said.find('+')) : file;
}

std::vector<std::string> changes_of(std::string_view said) {
  std::string_view rest = said.substr(base_of(said).size());
  std::vector<std::string> changes;
  while (!rest.empty()) {
    rest.remove_prefix(1);
    const std::size_t end = std::min(rest.find('+'), rest.size());
    changes.emplace_back(rest.substr(0, end));
    rest.remove_prefix(end);
  }
  return changes;
}

std::string name_of_edits(std::span<const Figure> figures, std::span<const Figure> original) {
  std::string name;
  for (const Figure& figure : original) {
    const auto found = std::ranges::find(figures, figure.key, &Figure::key);
    if (found->value != figure.value) name += fmt::format("+{}={}", found->key, found->value);
  }
  return name;
}

}  // namespace csgsim::machines
