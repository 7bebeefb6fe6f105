// Grouping of rows by model, machine or another key.
// Used by studies with points on several models and machines.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "hw/base/error.h"
#include "sim/studies/folder.h"

namespace csgsim::studies {

/// Groups the rows by model; rows of one model are adjacent.
template <class Row>
std::vector<std::span<const Row>> group_by_model(std::span<const Row> rows) {
  std::vector<std::span<const Row>> models;
  for (auto begin = rows.begin(); begin != rows.end();) {
    const auto end =
        std::find_if(begin, rows.end(), [&](const Row& row) { return row.point.model != begin->point.model; });
    models.emplace_back(begin, end);
    begin = end;
  }
  return models;
}

/// Groups the rows by key, in order of first appearance of the keys.
template <class Row, class KeyOf>
auto grouped_by(std::span<const Row> rows, const KeyOf& key_of) {
  using Key = std::decay_t<decltype(key_of(rows.front()))>;
  std::vector<std::pair<Key, std::vector<const Row*>>> groups;
  for (const Row& row : rows) {
    Key key = key_of(row);
    auto group = std::ranges::find(groups, key, [](const auto& one) -> const Key& { return one.first; });
    if (group == groups.end()) group = groups.insert(groups.end(), {std::move(key), {}});
    group->second.push_back(&row);
  }
  return groups;
}

/// The machines of the rows, in order of first appearance.
template <class Row>
std::vector<std::string> machines_of(std::span<const Row> rows) {
  std::vector<std::string> names;
  for (const Row& row : rows) {
    if (std::ranges::find(names, row.point.machine) == names.end()) names.push_back(row.point.machine);
  }
  return names;
}

/// Throws InputError that lists the models without any measured row; `table` is the file with the reasons.
template <class Row>
void refuse_failed_models(std::span<const Row> rows, const std::string& table) {
  std::vector<std::string> failed;
  const std::vector<std::span<const Row>> models = group_by_model(rows);
  for (const std::span<const Row> model : models) {
    if (std::ranges::none_of(model, [](const Row& row) { return row.reason.empty(); }))
      failed.push_back(model.front().point.model);
  }
  if (!failed.empty()) throw InputError(failed_models_message(failed, models.size(), table));
}

}  // namespace csgsim::studies
