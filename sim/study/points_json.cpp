#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "sim/study/comparison.h"
#include "sim/study/measure.h"
#include "sim/study/sweep.h"

namespace csgsim::study {

namespace {

using Json = nlohmann::ordered_json;

template <class Value>
Json value_of(const Value& value) {
  return value;
}

template <class Value>
Json value_of(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

/// Adds the columns that visit_columns tells of.
template <class Row>
void add_columns(Json& json, const Row& row) {
  visit_columns(row, [&](const char* name, const auto& member) { json[name] = value_of(member); });
}

template <class Row>
Json to_json(const Row& row) {
  Json json;
  add_columns(json, row);
  return json;
}

/// Where there is no Program, only the point and why.
Json sweep_json(const SweepRow& row) {
  if (row.compiled()) return to_json(row);
  Json json;
  add_columns(json, row.point);
  add_columns(json, row.inputs);
  json["reason"] = row.reason;
  return json;
}

/// Each point is row_json(row).
template <class Row>
std::string file_of(const std::string& title, std::span<const Row> rows, Json row_json(const Row&)) {
  Json json{{"study", title}, {"points", Json::array()}};
  for (const Row& row : rows) json["points"].push_back(row_json(row));
  return json.dump(2) + "\n";
}

}  // namespace

std::string points_json(const std::string& title, std::span<const Measurement> rows) {
  return file_of(title, rows, to_json<Measurement>);
}

std::string points_json(const std::string& title, std::span<const ComparisonRow> rows) {
  return file_of(title, rows, to_json<ComparisonRow>);
}

std::string points_json(const std::string& title, std::span<const SweepRow> rows) {
  return file_of(title, rows, sweep_json);
}

}  // namespace csgsim::study
