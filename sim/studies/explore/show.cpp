#include "sim/studies/explore/show.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "hw/base/text.h"
#include "sim/plots/common_looks.h"
#include "sim/session/options/numbers.h"
#include "sim/studies/design/axes.h"
#include "sim/studies/design/value_text.h"
#include "sim/studies/groups.h"
#include "sim/studies/plot_names.h"
#include "sim/studies/rows_json.h"

namespace csgsim::studies {

namespace {

/// Maximum number of printed rows of a front; the files have all.
constexpr std::size_t max_printed = 40;

void print_front(std::span<const ExploreRow> rows, const DesignNames& names, const ExploreGroup& group) {
  std::vector<std::vector<std::string>> lines(1, names.keys());
  for (const ExploreAxis& axis : group.axes) lines[0].emplace_back(axis.title);
  const std::vector<std::size_t> front = front_indices(group.values);
  for (const std::size_t one : front) {
    if (lines.size() > max_printed) break;
    lines.push_back(names.values(rows[group.rows[one]].point));
    for (const double value : group.values[one]) lines.back().push_back(value_text(value));
    if (one == group.knee) lines.back().emplace_back("knee");
  }
  lines[0].emplace_back("");
  for (std::vector<std::string>& line : lines) line.resize(lines[0].size());
  print_cells(lines);
  if (front.size() > max_printed) fmt::print("  and {} more, in explore.json\n", grouped(front.size() - max_printed));
}

std::string group_text(const ExploreGroup& group) {
  const auto on_front = static_cast<std::uint64_t>(std::ranges::count(group.front, true));
  std::string text =
      fmt::format("{}: {} of {} on the front", group.model.empty() ? "All models" : group.model, grouped(on_front),
                  session::count_text(group.values.size() + group.refused + group.unpriced, "design"));
  if (group.refused > 0) text += fmt::format("; {} cannot be drawn", grouped(group.refused));
  if (group.unpriced > 0)
    text += fmt::format("; {} omitted because an axis has no value for them", grouped(group.unpriced));
  return text;
}

/// Prints each reason once, with the first design that it applies to.
void print_refused(std::span<const ExploreRow> rows, const DesignNames& names, const std::string& model) {
  for (const auto& [reason, refused] :
       grouped_by(rows, [&](const ExploreRow& row) { return row.point.model == model ? row.reason : std::string(); })) {
    if (reason.empty()) continue;
    const std::size_t more = refused.size() - 1;
    const std::string others = more > 0 ? fmt::format(" and {}", session::count_text(more, "other design")) : "";
    fmt::print("  {}{} cannot be drawn: {}\n", names.text(refused.front()->point), others, reason);
  }
}

void print_knee(std::span<const ExploreRow> rows, const DesignNames& names, const ShownGroup& shown) {
  const ExploreGroup& group = shown.group;
  std::string values;
  for (std::size_t axis = 0; axis < group.axes.size(); ++axis)
    values += fmt::format("; {} {}", group.axes[axis].title, value_text(group.values[*group.knee][axis]));
  fmt::print("knee: {}{}\n", names.text(rows[group.rows[*group.knee]].point), values);
  for (const std::string& command : shown.commands) fmt::print("  {}\n", command);
}

using Json = nlohmann::ordered_json;

/// Numbers as JSON integers, everything else as strings.
Json value_json(const std::string& text) {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc{} && end == text.data() + text.size()) return number;
  return text;
}

/// The values of a design that vary.
Json design_json(const DesignNames& names, const DesignPoint& point) {
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

/// Two of a group's axes, and the candidates in their plane.
struct Panel {
  const ExploreGroup& group;
  std::size_t axis;  ///< the y axis; x is the first axis

  [[nodiscard]] plots::Point at(std::size_t candidate) const {
    return {group.values[candidate][0], group.values[candidate][axis]};
  }
};

/// The front of these two axes alone, in ascending order of the first.
std::vector<plots::Point> pair_front(const Panel& panel) {
  std::vector<Values> pairs;
  for (const Values& values : panel.group.values) pairs.push_back({values[0], values[panel.axis]});
  std::vector<plots::Point> front;
  for (const std::size_t one : front_indices(pairs)) front.push_back(panel.at(one));
  return front;
}

void add_panel(const Panel& panel, plots::Chart& chart) {
  const ExploreGroup& group = panel.group;
  const std::size_t number = chart.panels.size();
  const ExploreAxis& axis = group.axes[panel.axis];
  chart.panels.push_back({axis.title, plots::Scale::logarithmic});
  plots::Series is_dominated{number == 0 ? "dominated" : "", number, plots::Trace::marks, {}, true};
  plots::Series best{"Pareto front", number, plots::Trace::marks};
  for (std::size_t i = 0; i < group.values.size(); ++i)
    (group.front[i] ? best : is_dominated).points.push_back(panel.at(i));
  plots::Series of_two{"front of the two axes", number, plots::Trace::steps, pair_front(panel)};
  plots::Series knee{"knee", number, plots::Trace::marks, {panel.at(*group.knee)}};
  for (plots::Series* const series : {&is_dominated, &best, &of_two, &knee}) {
    if (!series->points.empty()) chart.series.push_back(std::move(*series));
  }
}

}  // namespace

DesignNames::DesignNames(std::span<const ExploreRow> rows) {
  std::map<std::string, std::set<std::string>> values;
  std::vector<std::string> order;
  for (const ExploreRow& row : rows) {
    for (auto& [key, value] : distinguishing_options(row.point)) {
      if (!values.contains(key)) order.push_back(key);
      values[key].insert(value);
    }
  }
  std::ranges::copy_if(order, std::back_inserter(keys_),
                       [&](const std::string& key) { return values[key].size() > 1; });
}

std::vector<std::string> DesignNames::values(const DesignPoint& point) const {
  const auto texts = distinguishing_options(point);
  std::vector<std::string> values;
  for (const std::string& key : keys_) {
    const auto found = std::ranges::find(texts, key, &std::pair<std::string, std::string>::first);
    values.push_back(found == texts.end() ? "" : found->second);
  }
  return values;
}

std::string DesignNames::text(const DesignPoint& point) const {
  const std::vector<std::string> of_keys = values(point);
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < keys_.size(); ++i) {
    if (!of_keys[i].empty()) parts.push_back(keys_[i] + "=" + of_keys[i]);
  }
  return parts.empty() ? point.machine : fmt::format("{}", fmt::join(parts, ", "));
}

DesignLabels designs_of(std::span<const ExploreRow> stated, const SensitivityOutcome& sensitivity) {
  std::vector<ExploreRow> drawn;
  std::ranges::copy_if(stated, std::back_inserter(drawn), &ExploreRow::is_compiled);
  const DesignNames names(drawn);
  DesignLabels labels;
  for (const ExploreRow& row : stated.first(sensitivity.order.designs)) {
    labels.texts.push_back(names.text(row.point));
    labels.json.push_back(design_json(names, row.point));
  }
  return labels;
}

void print_explored(std::span<const ExploreRow> rows, std::span<const ShownGroup> groups) {
  const DesignNames names(rows);
  bool is_first = true;
  for (const ShownGroup& shown : groups) {
    fmt::print("{}{}\n", is_first ? "" : "\n", group_text(shown.group));
    is_first = false;
    if (!shown.group.model.empty()) print_refused(rows, names, shown.group.model);
    if (!shown.group.knee) continue;
    print_front(rows, names, shown.group);
    print_knee(rows, names, shown);
  }
}

std::string explore_json(const std::string& title, std::span<const ExploreRow> rows, std::span<const ShownGroup> groups,
                         const SensitivityOutcome* sensitivity) {
  const std::size_t variants = sensitivity == nullptr ? 1 : sensitivity->order.variants;
  const std::vector<ExploreRow> stated = stated_rows(rows, variants);
  const DesignNames names(stated);
  std::map<std::size_t, std::pair<bool, bool>>
      marks;  // per stated row: whether it is on its model's front, and whether it is the knee
  for (const ShownGroup& shown : groups) {
    const ExploreGroup& group = shown.group;
    for (std::size_t i = 0; i < group.rows.size() && !group.model.empty(); ++i)
      marks[group.rows[i]] = {group.front[i], group.knee == i};
  }
  const SetPoint columns = make_point_setter(rows);
  Json json = points_json(title, rows.size(), [&](Json& point, std::size_t row) {
    columns(point, row);
    point["design"] = design_json(names, rows[row].point);
    if (sensitivity != nullptr) point["figures"] = variant_json(sensitivity->variants, row % variants);
    if (!rows[row].is_compiled() || row % variants != 0) return;
    const std::pair<bool, bool>& mark = marks[row / variants];
    point["pareto"] = mark.first;
    point["knee"] = mark.second;
  });
  json["fronts"] = Json::array();
  for (const ShownGroup& shown : groups) json["fronts"].push_back(group_json(stated, names, shown));
  if (sensitivity != nullptr) json["sensitivity"] = sensitivity_json(*sensitivity, designs_of(stated, *sensitivity));
  return json_file_text(json);
}

std::vector<plots::Plot> plots_of_explore(std::span<const ShownGroup> groups) {
  std::vector<plots::Plot> all;
  PlotNames plot_names;
  for (const ShownGroup& shown : groups) {
    const ExploreGroup& group = shown.group;
    if (!group.knee || group.axes.size() < 2) continue;
    const std::string name = plot_names.next(group.model.empty() ? "all_models" : plot_stem(group.model));
    plots::Chart chart{
        fmt::format("{}: trade-offs against {}", group.model.empty() ? "all models" : name, group.axes[0].name),
        {group.axes[0].title, plots::Scale::logarithmic},
        {},
        {},
        "explore.csv"};
    for (std::size_t axis = 1; axis < group.axes.size(); ++axis) add_panel({group, axis}, chart);
    all.push_back({name + "_front", std::move(chart)});
  }
  plots::set_common_looks(all);
  return all;
}

}  // namespace csgsim::studies
