#include "sim/studies/compare/costly_cell.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "hw/base/error.h"
#include "hw/base/text.h"
#include "sim/studies/csv.h"

namespace csgsim::studies {

namespace {

/// Replaces the characters that separate entries of a cell; names of models that csgsim reads contain none.
std::string as_word(std::string name) {
  std::ranges::replace_if(
      name, [](char c) { return c == ' ' || c == '=' || c == '\t'; }, '_');
  return name;
}

}  // namespace

CostlyPrimitives costly_primitives(const observe::ClockShares& shares) {
  CostlyPrimitives primitives;
  for (const observe::PrimitiveCost& one : shares.most_expensive)
    primitives.push_back({as_word(escaped(one.name)), one.clocks});
  return primitives;
}

std::string to_cell(const CostlyPrimitives& primitives) {
  std::string cell;
  for (const CostlyPrimitive& one : primitives)
    cell += fmt::format("{}{}={}", cell.empty() ? "" : " ", one.name, one.clocks);
  return to_cell(cell);
}

void from_cell(const std::string& cell, CostlyPrimitives& primitives) {
  primitives.clear();
  std::istringstream words(cell);
  for (std::string word; words >> word;) {
    const std::size_t equals = word.rfind('=');
    if (equals == std::string::npos) throw InputError("'" + word + "' is not of the form name=clocks");
    CostlyPrimitive one{word.substr(0, equals), 0};
    from_cell(word.substr(equals + 1), one.clocks);
    primitives.push_back(std::move(one));
  }
}

void set_json(nlohmann::ordered_json& row, const char* name, const CostlyPrimitives& primitives) {
  row[name] = nlohmann::ordered_json::array();
  for (const CostlyPrimitive& part : primitives) row[name].push_back({{"name", part.name}, {"clocks", part.clocks}});
}

}  // namespace csgsim::studies
