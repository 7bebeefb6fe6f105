#include <fmt/format.h>

#include <string>
#include <utility>

#include "sim/studies/sensitivity/show.h"

namespace csgsim::studies {

namespace {

using report::Cell;
using report::Json;
using report::Table;

std::string group_name(const Json& group) {
  return group["model"].is_null() ? "All models" : group["model"].get<std::string>();
}

std::string design_text(const Json& design) {
  std::string text;
  for (const auto& [key, value] : design["design"].items())
    text += fmt::format("{}{}={}", text.empty() ? "" : ", ", key,
                        value.is_string() ? value.get<std::string>() : value.dump());
  return text;
}

std::string figures_text(const Json& figures) {
  std::string text;
  for (const Json& one : figures)
    text += fmt::format("{}{}={}", text.empty() ? "" : ", ", one["key"].get<std::string>(), one["value"].dump());
  return text;
}

void add_comparisons(const Json& data, const std::string& at, Table& table) {
  const Json& design = data.at(Json::json_pointer(at));
  for (std::size_t i = 0; i < design["metrics"].size(); ++i) {
    if (!design["metrics"][i].contains("against_first")) continue;
    const std::string metric = fmt::format("{}/metrics/{}", at, i);
    const std::string against = metric + "/against_first";
    table.rows.push_back(
        {Cell{design_text(design)}, report::cell(data, metric + "/axis"), report::cell(data, against + "/ratio/base"),
         report::cell(data, against + "/lowest_ratio"), report::cell(data, against + "/highest_ratio"),
         report::cell(data, against + "/ratio/samples/p5"), report::cell(data, against + "/ratio/samples/p95"),
         Cell{figures_text(design["metrics"][i]["against_first"]["sign_changes"]["figures"])},
         report::cell(data, against + "/sign_changes/samples")});
  }
}

Table comparisons_table(const Json& data, const std::string& at) {
  const Json& group = data.at(Json::json_pointer(at));
  Table table{group_name(group) + ": ratios to the first design over the ranges of the assumed figures",
              {"design", "metric", "ratio", "lowest, one figure", "highest, one figure", "5 % of samples",
               "95 % of samples", "figures that change the sign", "samples that change it"},
              {}};
  for (std::size_t i = 1; i < group["designs"].size(); ++i)
    add_comparisons(data, fmt::format("{}/designs/{}", at, i), table);
  return table;
}

}  // namespace

report::Section sensitivity_section(const Json& data) {
  report::Section section{"Sensitivity", {}};
  for (std::size_t i = 0; i < data["sensitivity"]["groups"].size(); ++i) {
    Table table = comparisons_table(data, fmt::format("/sensitivity/groups/{}", i));
    if (!table.rows.empty()) section.parts.emplace_back(std::move(table));
  }
  return section;
}

}  // namespace csgsim::studies
