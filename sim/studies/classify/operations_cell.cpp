#include "sim/studies/classify/operations_cell.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>

#include "hw/base/error.h"
#include "sim/studies/csv.h"

namespace csgsim::software {

std::string to_cell(const Operations& operations) {
  std::string cell;
  for (std::size_t kind = 0; kind < operation_kinds; ++kind) {
    if (operations.counts[kind] == 0) continue;
    cell += fmt::format("{}{}={}", cell.empty() ? "" : " ", operation_rows[kind].name, operations.counts[kind]);
  }
  return studies::to_cell(cell);
}

void from_cell(const std::string& cell, Operations& operations) {
  operations = {};
  std::istringstream words(cell);
  for (std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    const std::string_view name = std::string_view(word).substr(0, equals);
    const auto* const row =
        std::ranges::find_if(operation_rows, [&](const OperationRow& one) { return one.name == name; });
    if (equals == std::string::npos || row == operation_rows.end())
      throw InputError("'" + word + "' is not of the form operation=times");
    studies::from_cell(word.substr(equals + 1),
                       operations.counts[static_cast<std::size_t>(row - operation_rows.begin())]);
  }
}

void set_json(nlohmann::ordered_json& row, const char* name, const Operations& operations) {
  row[name] = nlohmann::ordered_json::object();
  for (std::size_t kind = 0; kind < operation_kinds; ++kind) {
    if (operations.counts[kind] > 0) row[name][operation_rows[kind].name] = operations.counts[kind];
  }
}

}  // namespace csgsim::software
