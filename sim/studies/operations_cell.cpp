#include "sim/studies/operations_cell.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>

#include "hw/base/error.h"
#include "sim/studies/csv.h"

namespace csgsim::studies {

using software::operation_kinds;
using software::operation_rows;

std::string to_cell(const OperationsCell& cell) {
  std::string text;
  for (std::size_t kind = 0; kind < operation_kinds; ++kind) {
    const std::uint64_t count = cell.operations.counts[kind];
    if (count > 0) text += fmt::format("{}{}={}", text.empty() ? "" : " ", operation_rows[kind].name, count);
  }
  return to_cell(text);
}

void from_cell(const std::string& text, OperationsCell& cell) {
  cell = {};
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    const std::string_view name = std::string_view(word).substr(0, equals);
    const auto* const row =
        std::ranges::find_if(operation_rows, [&](const processors::OperationRow& one) { return one.name == name; });
    if (equals == std::string::npos || row == operation_rows.end())
      throw InputError("'" + word + "' is not of the form operation=count");
    from_cell(word.substr(equals + 1), cell.operations.counts[static_cast<std::size_t>(row - operation_rows.begin())]);
  }
}

void set_json(nlohmann::ordered_json& row, const char* name, const OperationsCell& cell) {
  row[name] = nlohmann::ordered_json::object();
  for (std::size_t kind = 0; kind < operation_kinds; ++kind) {
    const std::uint64_t count = cell.operations.counts[kind];
    if (count > 0) row[name][operation_rows[kind].name] = count;
  }
}

}  // namespace csgsim::studies
