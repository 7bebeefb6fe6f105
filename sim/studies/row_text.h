#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "hw/base/error.h"
#include "hw/base/text.h"
#include "sim/studies/csv.h"

namespace csgsim::studies {

/// Names of a row's columns as a line of CSV. visit_columns(row, visit), found beside the row's type, calls
/// visit(name, member) for each.
template <class Row>
std::string header_of() {
  std::string line;
  const Row none{};
  visit_columns(none, [&](const char* name, const auto&) { line += (line.empty() ? "" : ",") + std::string(name); });
  return line;
}

template <class Row>
std::string to_line(const Row& row) {
  std::string line;
  bool first = true;
  visit_columns(row, [&](const char*, const auto& member) {
    line += (first ? "" : ",") + to_cell(member);
    first = false;
  });
  return line;
}

/// Throws InputError that says which cell cannot be read, or is not as printable() leaves texts.
template <class Row>
Row from_line(const std::string& line) {
  Row row;
  const std::vector<std::string> cells = split_cells(line);
  std::size_t next = 0;
  visit_columns(row, [&](const char* name, auto& member) {
    if (next == cells.size()) throw InputError(std::string("there is no ") + name);
    const std::string& cell = cells[next++];
    if (printable(cell) != cell) throw InputError(fmt::format("{} is '{}', no text of a table", name, printable(cell)));
    from_cell(cell, member);
  });
  if (next < cells.size()) throw InputError("'" + cells[next] + "' is one cell too many");
  return row;
}

}  // namespace csgsim::studies
