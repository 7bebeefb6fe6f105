// Conversion of rows to and from lines of CSV.
// Used by the tables and shards of studies.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <vector>

#include "hw/base/error.h"
#include "hw/base/text.h"
#include "sim/studies/csv.h"

namespace csgsim::studies {

/// Column names of a row type as a line of CSV. Row::columns(row, visit) calls visit(name, member) for each column in
/// order.
template <class Row>
std::string header_line() {
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

/// Throws InputError that names the cell that cannot be read or contains unprintable characters.
template <class Row>
Row from_line(const std::string& line) {
  Row row;
  const std::vector<std::string> cells = split_cells(line);
  std::size_t next = 0;
  Row::columns(row, [&](const char* name, auto& member) {
    if (next == cells.size()) throw InputError(std::string("missing cell ") + name);
    const std::string& cell = cells[next++];
    if (printable(cell) != cell)
      throw InputError(fmt::format("{} contains unprintable characters: '{}'", name, printable(cell)));
    from_cell(cell, member);
  });
  if (next < cells.size()) throw InputError("'" + cells[next] + "' is an extra cell");
  return row;
}

/// Properties of a row type that a table needs to handle rows as lines.
struct RowFormat {
  std::string columns;                              ///< column names as a line
  std::size_t point_columns = 0;                    ///< number of leading columns that identify the point
  void (*check)(const std::string& row) = nullptr;  ///< throws InputError if a line is not a valid row
};

/// The first `Row::point_columns` columns identify the point.
template <class Row>
RowFormat row_format() {
  return {header_line<Row>(), Row::point_columns,
          [](const std::string& row) { static_cast<void>(from_line<Row>(row)); }};
}

}  // namespace csgsim::studies
