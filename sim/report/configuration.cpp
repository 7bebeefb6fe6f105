#include "sim/report/configuration.h"

#include <fmt/format.h>

#include <cstddef>

namespace csgsim::report {

namespace {

constexpr std::size_t max_elements = 16;

bool is_list_of_leaves(const Json& value) {
  if (!value.is_array() || value.size() > max_elements) return false;
  for (const Json& one : value)
    if (one.is_structured()) return false;
  return true;
}

void add_leaves(const Json& value, const std::string& at, const std::string& name, Table& table) {
  if (value.is_null()) return;
  if (value.is_object() && !value.empty()) {
    for (const auto& [key, one] : value.items())
      add_leaves(one, child_pointer(at, key), name.empty() ? key : fmt::format("{}.{}", name, key), table);
  } else if (value.is_array() && value.size() <= max_elements && !is_list_of_leaves(value)) {
    for (std::size_t i = 0; i < value.size(); ++i)
      add_leaves(value[i], at + "/" + std::to_string(i), name + "[" + std::to_string(i) + "]", table);
  } else if (value.is_array() && value.size() > max_elements) {
    table.rows.push_back({{name}, {std::to_string(value.size()) + " values, see the page's data"}});
  } else {
    table.rows.push_back({{name}, {value.is_structured() && value.empty() ? Json("none") : value, at}});
  }
}

}  // namespace

Table leaf_table(const Json& data, const std::string& at, const std::string& caption) {
  Table table{caption, {"key", "value"}, {}, true};
  const Json::json_pointer pointer(at);
  if (data.contains(pointer)) add_leaves(data.at(pointer), at, "", table);
  return table;
}

namespace {

/// The machine's parameters, with units and provenance.
Table machine_table(const Json& machine) {
  Table table{
      "Parameters of " + machine.at("name").get<std::string>(), {"parameter", "value", "unit", "provenance"}, {}, true};
  for (const auto& [key, figure] : machine.at("figures").items())
    table.rows.push_back({{key}, {figure.at("value")}, {figure.value("unit", "")}, {figure.at("provenance")}});
  return table;
}

}  // namespace

Section configuration_section(const Json& data, const Context& context) {
  Section section{"Configuration", {}};
  if (data.contains("configuration")) {
    section.parts.emplace_back(leaf_table(data, "/configuration", "Effective configuration"));
    return section;
  }
  Table options{"Options, given or default", {"option", "value"}, {}, true};
  for (const auto& [name, value] : context.options) options.rows.push_back({{name}, {value}});
  section.parts.emplace_back(std::move(options));
  for (const Json& machine : context.machines) section.parts.emplace_back(machine_table(machine));
  return section;
}

std::vector<Part> sentences(const Json& data, const std::string& at) {
  std::vector<Part> parts;
  const Json::json_pointer pointer(at);
  if (!data.contains(pointer)) return parts;
  const auto add = [&](const Json& one) {
    const Json& sentence = one.is_object() && one.contains("sentence") ? one["sentence"] : one;
    if (sentence.is_string()) parts.emplace_back(Paragraph{sentence.get<std::string>()});
  };
  const Json& value = data.at(pointer);
  if (!value.is_array()) {
    add(value);
  } else {
    for (const Json& one : value) add(one);
  }
  return parts;
}

}  // namespace csgsim::report
