#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "sim/studies/inputs.h"

namespace csgsim::studies {

template <class Value>
nlohmann::ordered_json value_json(const Value& value) {
  return value;
}

template <class Value>
nlohmann::ordered_json value_json(const std::optional<Value>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

/// Whether the row says why its point could not be measured, in place of the counts.
template <class Row>
bool is_refused(const Row& row) {
  if constexpr (requires { row.reason.empty(); }) return !row.reason.empty();
  return false;
}

/// The columns that visit_columns tells of; of a point that could not be measured only which it is, and why.
template <class Row>
nlohmann::ordered_json row_json(const Row& row) {
  const std::size_t told = is_refused(row) ? Row::point_columns + input_columns : static_cast<std::size_t>(-1);
  nlohmann::ordered_json json;
  std::size_t column = 0;
  visit_columns(row, [&](const char* name, const auto& member) {
    if (column++ < told || std::string_view(name) == "reason") json[name] = value_json(member);
  });
  return json;
}

/// A study's file of points.
template <class Row>
nlohmann::ordered_json points_json(const std::string& title, std::span<const Row> rows) {
  nlohmann::ordered_json json{{"study", title}, {"points", nlohmann::ordered_json::array()}};
  for (const Row& row : rows) json["points"].push_back(row_json(row));
  return json;
}

template <class Row>
std::string rows_json(const std::string& title, std::span<const Row> rows) {
  return points_json(title, rows).dump(2) + "\n";
}

}  // namespace csgsim::studies
