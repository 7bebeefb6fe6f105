#include "sim/report/points.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>

#include "sim/report/number_text.h"

namespace csgsim::report {

namespace {

/// Anything but nothing, or no words.
bool holds_something(const Json& point, const std::string& key) {
  if (!point.contains(key) || point[key].is_null()) return false;
  return !point[key].is_string() || !point[key].get_ref<const std::string&>().empty();
}

}  // namespace

std::string word_of(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  return value.is_number() ? number_text(value.get<double>())
                           : value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

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
  if (has_reasons) table.columns.emplace_back("why not");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string here = at + "/" + std::to_string(i);
    Row row;
    for (const PointColumn& column : shown) row.push_back(cell(data, here + "/" + column.key, column.show));
    if (has_reasons) row.push_back(cell(data, here + "/reason"));
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::vector<std::string> words_of(std::span<const Json> points, const std::string& key) {
  std::vector<std::string> words;
  for (const Json& point : points) {
    if (!point.contains(key)) continue;
    const std::string word = word_of(point[key]);
    if (std::find(words.begin(), words.end(), word) == words.end()) words.push_back(word);
  }
  return words;
}

std::vector<Series> series_of(std::span<const Json> points, const Curve& curve) {
  std::vector<Series> all;
  for (const Json& point : points) {
    if (!is_measured(point)) continue;
    const std::string name = curve.line(point);
    auto series = std::find_if(all.begin(), all.end(), [&](const Series& one) { return one.name == name; });
    if (series == all.end()) series = all.insert(all.end(), {name, {}});
    series->points.push_back({curve.x(point), curve.y(point), curve.label(point)});
  }
  std::vector<Series> apart;
  std::map<std::size_t, unsigned> alike;
  for (Series& series : all) {
    const auto same = std::find_if(apart.begin(), apart.end(), [&](const Series& one) {
      return std::equal(one.points.begin(), one.points.end(), series.points.begin(), series.points.end(),
                        [](const Point& a, const Point& b) { return a.x == b.x && a.y == b.y; });
    });
    if (same == apart.end()) {
      apart.push_back(std::move(series));
    } else {
      ++alike[static_cast<std::size_t>(same - apart.begin())];
    }
  }
  for (const auto& [index, count] : alike) apart[index].name += fmt::format(" (+ {} alike)", count);
  return apart;
}

std::function<double(const Json&)> place_in(const std::vector<std::string>& words, const std::string& key) {
  return [words, key](const Json& point) {
    return static_cast<double>(std::find(words.begin(), words.end(), word_of(point.at(key))) - words.begin());
  };
}

std::function<double(const Json&)> number_at(const std::string& key) {
  return [key](const Json& point) { return point.at(key).get<double>(); };
}

}  // namespace csgsim::report
