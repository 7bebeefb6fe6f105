// Conversion of rows to JSON.
// Used by the JSON files of studies.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "sim/studies/inputs.h"

namespace csgsim::studies {

/// Sets a member of a row's JSON object. Other cell types have overloads in their own headers.
void set_json(nlohmann::ordered_json& row, const char* name, std::uint64_t value);
void set_json(nlohmann::ordered_json& row, const char* name, double value);
void set_json(nlohmann::ordered_json& row, const char* name, const std::string& value);
void set_json(nlohmann::ordered_json& row, const char* name, std::nullopt_t none);

inline void set_json(nlohmann::ordered_json& row, const char* name, std::unsigned_integral auto value) {
  set_json(row, name, std::uint64_t{value});
}

template <class Value>
void set_json(nlohmann::ordered_json& row, const char* name, const std::optional<Value>& value) {
  value ? set_json(row, name, *value) : set_json(row, name, std::nullopt);
}

/// Sets the columns of a row; for a point that could not be measured, only the columns of the point and the reason.
template <class Row>
void set_columns(nlohmann::ordered_json& json, const Row& row) {
  bool is_refused = false;
  if constexpr (requires { row.reason.empty(); }) is_refused = !row.reason.empty();
  const std::size_t shown_columns = is_refused ? Row::point_columns + input_columns : static_cast<std::size_t>(-1);
  std::size_t column = 0;
  Row::columns(row, [&](const char* name, const auto& member) {
    if (column++ < shown_columns || std::string_view(name) == "reason") set_json(json, name, member);
  });
}

/// Calls set(json, point) for each point of a study.
using SetPoint = std::function<void(nlohmann::ordered_json& json, std::size_t point)>;

/// The JSON of a study with `point_count` points.
nlohmann::ordered_json points_json(const std::string& title, std::size_t point_count, const SetPoint& set_point);
std::string points_json_text(const std::string& title, std::size_t point_count, const SetPoint& set_point);

/// The JSON formatted as in a file.
std::string json_file_text(const nlohmann::ordered_json& json);

template <class Row>
SetPoint make_point_setter(std::span<const Row> rows) {
  return [rows](nlohmann::ordered_json& json, std::size_t point) { set_columns(json, rows[point]); };
}

template <class Row>
std::string rows_json(const std::string& title, std::span<const Row> rows) {
  return points_json_text(title, rows.size(), make_point_setter(rows));
}

}  // namespace csgsim::studies
