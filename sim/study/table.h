#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hw/base/text.h"
#include "sim/study/csv.h"
#include "sim/study/inputs.h"

namespace csgsim::study {

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

/// The rows of a study, kept in a CSV file that grows by a line a point.
template <class Row>
class Table {
 public:
  /// Opens or begins a table. Throws InputError if the file holds another study (another `title`) or no table.
  Table(std::filesystem::path path, const std::string& title) : file_(std::move(path), title, header_of<Row>()) {
    for (std::size_t i = 0; i < file_.found().size(); ++i) {
      try {
        rows_.push_back(from_line<Row>(file_.found()[i]));
      } catch (const InputError& error) {
        file_.refuse(i, error.what());
      }
    }
  }

  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }

  /// The row that measures(row, wanted) holds of, or null.
  template <class Wanted>
  [[nodiscard]] const Row* find(const Wanted& wanted) const {
    const auto found = std::find_if(rows_.begin(), rows_.end(), [&](const Row& row) { return measures(row, wanted); });
    return found == rows_.end() ? nullptr : &*found;
  }

  /// Deletes the rows that is_stale(row, wanted) holds of: measured from other inputs than those of now. Returns what
  /// has changed since.
  template <class Wanted>
  std::set<std::string> drop_stale(std::span<const Wanted> all_wanted) {
    std::set<std::string> changed;
    std::vector<Row> kept;
    for (const Row& row : rows_) {
      const auto wanted =
          std::find_if(all_wanted.begin(), all_wanted.end(), [&](const Wanted& one) { return is_stale(row, one); });
      if (wanted == all_wanted.end()) {
        kept.push_back(row);
        continue;
      }
      for (std::string& name : differences(row.inputs, wanted->inputs)) changed.insert(std::move(name));
    }
    if (kept.size() < rows_.size()) replace(std::move(kept));
    return changed;
  }

  void add(Row row) {
    file_.append(to_line(row));
    rows_.push_back(std::move(row));
  }

  /// Adds several at once, which takes no longer than one.
  void add(std::vector<Row> rows) {
    if (rows.empty()) return;
    std::string lines;
    for (const Row& row : rows) lines += (lines.empty() ? "" : "\n") + to_line(row);
    file_.append(lines);
    rows_.insert(rows_.end(), std::make_move_iterator(rows.begin()), std::make_move_iterator(rows.end()));
  }

  void replace(std::vector<Row> rows) {
    std::vector<std::string> lines;
    lines.reserve(rows.size());
    for (const Row& row : rows) lines.push_back(to_line(row));
    file_.replace(lines);
    rows_ = std::move(rows);
  }

 private:
  CsvFile file_;
  std::vector<Row> rows_;
};

}  // namespace csgsim::study
