#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <vector>

#include "hw/base/error.h"
#include "hw/base/text.h"
#include "sim/studies/csv.h"

namespace csgsim::studies {

/// Names of a row's columns as a line of CSV. Row::columns(row, visit) calls visit(name, member) for each, in order.
template <class Row>
std::string header_of() {
  std::string line;
  const Row none{};
  Row::columns(none, [&](const char* name, const auto&) { line += (line.empty() ? "" : ",") + std::string(name); });
  return line;
}

template <class Row>
std::string to_line(const Row& row) {
  std::string line;
  bool first = true;
  Row::columns(row, [&](const char*, const auto& member) {
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
  Row::columns(row, [&](const char* name, auto& member) {
    if (next == cells.size()) throw InputError(std::string("there is no ") + name);
    const std::string& cell = cells[next++];
    if (printable(cell) != cell) throw InputError(fmt::format("{} is '{}', no text of a table", name, printable(cell)));
    from_cell(cell, member);
  });
  if (next < cells.size()) throw InputError("'" + cells[next] + "' is one cell too many");
  return row;
}

/// What of a table's rows has to be known to keep them as lines.
struct RowFormat {
  std::string columns;                              ///< their names, as a line
  std::size_t point_columns = 0;                    ///< the first ones, which say which point it is
  void (*check)(const std::string& row) = nullptr;  ///< throws InputError for a line that is no row
};

/// `Row::point_columns` of the columns say which point it is.
template <class Row>
RowFormat format_of() {
  return {header_of<Row>(), Row::point_columns, [](const std::string& row) { static_cast<void>(from_line<Row>(row)); }};
}

}  // namespace csgsim::studies
