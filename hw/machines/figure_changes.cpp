#include "hw/machines/figure_changes.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <map>

#include "hw/base/nearest.h"
#include "hw/machines/figure_file.h"

namespace csgsim::machines {

namespace {

/// Collects the parameters of a description by key: tables that contain a value.
void collect_figures(toml::table& table, const std::string& prefix, std::map<std::string, toml::table*>& figures) {
  for (auto&& [key, node] : table) {
    toml::table* const inner = node.as_table();
    if (inner == nullptr) continue;
    const std::string full = prefix + std::string(key.str());
    if (inner->contains("value")) figures.emplace(full, inner);
    collect_figures(*inner, full + ".", figures);
  }
}

/// Applies one change and returns the key of the parameter.
std::string put_change(toml::table& root, const std::string& change, std::string_view file) {
  const std::size_t equals = change.find('=');
  if (equals == change.npos) {
    throw ChangeError(fmt::format("{}: '{}' changes no parameter; write KEY=VALUE", file, change));
  }
  std::map<std::string, toml::table*> figures;
  collect_figures(root, "", figures);
  std::string key = change.substr(0, equals);
  const auto found = figures.find(key);
  if (found == figures.end()) {
    std::vector<std::string_view> known;
    known.reserve(figures.size());
    for (const auto& [name, table] : figures) known.push_back(name);
    throw ChangeError(fmt::format("{}: unknown parameter '{}'; the nearest known is '{}'", file, key,
                                  known.empty() ? "none" : nearest(key, known)));
  }
  const std::string value = change.substr(equals + 1);
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
  if (error == std::errc() && end == value.data() + value.size()) {
    found->second->insert_or_assign("value", number);
  } else {
    found->second->insert_or_assign("value", value);
  }
  found->second->insert_or_assign("provenance", "assumed");
  found->second->insert_or_assign("source", "set with the machine's name");
  for (const char* const limit : {"low", "high", "range"}) found->second->erase(limit);
  return key;
}

}  // namespace

AppliedChanges apply_changes(toml::table& root, std::span<const std::string> changes, std::string_view file) {
  AppliedChanges made{{}, std::string(file)};
  for (const std::string& change : changes) {
    made.keys.push_back(put_change(root, change, file));
    made.spec += "+" + change;
  }
  return made;
}

std::string changes_suffix(std::span<const std::string> keys, std::span<const Figure> figures) {
  std::string name;
  for (auto key = keys.begin(); key != keys.end(); ++key) {
    if (std::find(keys.begin(), key, *key) != key) continue;
    name += fmt::format("+{}={}", *key, std::ranges::find(figures, *key, &Figure::key)->value);
  }
  return name;
}

}  // namespace csgsim::machines
