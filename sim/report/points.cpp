#include "sim/report/points.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace csgsim::report {

namespace {

/// Whether the point has a value other than null and the empty text.
bool holds_something(const Json& point, const std::string& key) {
  const Json value = point.value(Json::json_pointer("/" + key), Json());
  return !value.is_null() && (!value.is_string() || !value.get_ref<const std::string&>().empty());
}

}  // namespace

bool is_measured(const Json& point) {
  return !point.contains("reason") || (point["reason"].is_string() && point["reason"].get<std::string>().empty());
}

Table points_table(const Json& data, const std::string& at, const std::string& caption,
                   std::span<const PointColumn> columns) {
  const Json& points = data.at(Json::json_pointer(at));
  const auto any = [&](auto holds) { return std::any_of(points.begin(), points.end(), holds); };
  const bool has_reasons = any([](const Json& point) { return !is_measured(point); });
  Table table{caption, {}, {}};
  std::vector<PointColumn> shown;
  for (const PointColumn& column : columns) {
    if (!any([&](const Json& point) { return holds_something(point, column.key); })) continue;
    shown.push_back(column);
    table.columns.emplace_back(column.title);
  }
  if (has_reasons) table.columns.emplace_back("reason");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string here = at + "/" + std::to_string(i);
    Row row;
    for (const PointColumn& column : shown) row.push_back(cell(data, here + "/" + column.key, column.show));
    if (has_reasons) row.push_back(cell(data, here + "/reason"));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace csgsim::report
