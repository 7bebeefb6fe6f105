#include <charconv>
#include <nlohmann/json.hpp>
#include <vector>

#include "sim/studies/explore/show.h"
#include "sim/studies/rows_json.h"

namespace csgsim::studies {

namespace {

using Json = nlohmann::ordered_json;

/// Whole numbers as such.
Json value_json(const std::string& text) {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc{} && end == text.data() + text.size()) return number;
  return text;
}

/// What the design is, without what all have.
Json design_json(const DesignNames& names, const ExplorePoint& point) {
  Json json = Json::object();
  const std::vector<std::string> values = names.values(point);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!values[i].empty()) json[names.keys()[i]] = value_json(values[i]);
  }
  return json;
}

Json candidate_json(std::span<const ExploreRow> rows, const DesignNames& names, const ExploreGroup& group,
                    std::size_t candidate) {
  Json values = Json::object();
  for (std::size_t axis = 0; axis < group.axes.size(); ++axis)
    values[group.axes[axis].name] = group.values[candidate][axis];
  return {{"design", design_json(names, rows[group.rows[candidate]].point)}, {"values", values}};
}

Json group_json(std::span<const ExploreRow> rows, const DesignNames& names, const ShownGroup& shown) {
  const ExploreGroup& group = shown.group;
  Json json{{"model", group.model.empty() ? Json(nullptr) : Json(group.model)},
            {"axes", Json::array()},
            {"designs", group.values.size() + group.refused + group.unpriced},
            {"refused", group.refused},
            {"unpriced", group.unpriced},
            {"front", Json::array()}};
  for (const ExploreAxis& axis : group.axes) json["axes"].push_back(axis.name);
  for (std::size_t i = 0; i < group.values.size(); ++i) {
    if (group.front[i]) json["front"].push_back(candidate_json(rows, names, group, i));
  }
  if (!group.knee) return json;
  json["knee"] = candidate_json(rows, names, group, *group.knee);
  json["knee"]["commands"] = shown.commands;
  return json;
}

/// Of each row, whether its candidate is so in its model's group.
std::vector<bool> rows_on_front(std::span<const ExploreRow> rows, std::span<const ShownGroup> groups) {
  std::vector<bool> is_on(rows.size());
  for (const ShownGroup& shown : groups) {
    if (shown.group.model.empty()) continue;
    for (std::size_t i = 0; i < shown.group.rows.size(); ++i) is_on[shown.group.rows[i]] = shown.group.front[i];
  }
  return is_on;
}

bool is_knee(std::span<const ShownGroup> groups, std::size_t row) {
  for (const ShownGroup& shown : groups) {
    const ExploreGroup& group = shown.group;
    if (!group.model.empty() && group.knee && group.rows[*group.knee] == row) return true;
  }
  return false;
}

}  // namespace

std::string explore_json(const std::string& title, std::span<const ExploreRow> rows,
                         std::span<const ShownGroup> groups) {
  const DesignNames names(rows);
  const std::vector<bool> is_on_front = rows_on_front(rows, groups);
  const SetPoint columns = setter_of(rows);
  Json json = points_json(title, rows.size(), [&](Json& point, std::size_t row) {
    columns(point, row);
    point["design"] = design_json(names, rows[row].point);
    if (!rows[row].drawn()) return;
    point["pareto"] = static_cast<bool>(is_on_front[row]);
    point["knee"] = is_knee(groups, row);
  });
  json["fronts"] = Json::array();
  for (const ShownGroup& shown : groups) json["fronts"].push_back(group_json(rows, names, shown));
  return file_text(json);
}

}  // namespace csgsim::studies
