#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "sim/studies/csv.h"
#include "sim/studies/gather.h"
#include "sim/studies/study.h"

namespace csgsim::studies {

/// The rows of a study, as lines; kept in a CSV file that grows by a line a point, if it has one.
class Table {
 public:
  /// Without a file.
  explicit Table(const Study& study) : study_(study) {}

  /// Opens or begins a table. Throws InputError if the file holds another study (another `title`) or no table.
  Table(const std::filesystem::path& path, const std::string& title, const Study& study);

  [[nodiscard]] bool empty() const { return rows_.empty(); }

  /// Deletes the rows of these points that were measured from other inputs than those of now; all such rows, if the
  /// table holds points of one model on one machine. Returns what has changed since.
  std::set<std::string> drop_stale(std::span<const Asked> asked, bool is_of_one_machine);

  /// Numbers of the points of which there is no row.
  [[nodiscard]] std::vector<std::size_t> missing(std::span<const Asked> asked) const;

  /// Adds rows and has them on the disk.
  void add(std::span<const std::string> rows);

  /// The rows of these points, of which none is missing, in their order. The table has them so too, before those of
  /// other points.
  std::vector<std::string> in_order(std::span<const Asked> asked);

  /// Takes the rows that shards have measured, of which none is missing. Throws InputError if one cannot be read, or if
  /// the table has others.
  std::vector<std::string> put(const Gathered& gathered);

 private:
  [[nodiscard]] std::string point_of(const std::string& row) const;
  [[nodiscard]] bool has_inputs(const std::string& row, const Asked& asked) const;
  /// The row that serves a point.
  [[nodiscard]] const std::string* find(std::span<const Asked> asked, std::size_t point) const;
  void take(std::vector<std::string> rows);

  const Study& study_;
  std::filesystem::path path_;
  std::optional<CsvFile> file_;
  std::vector<std::string> rows_;
  std::unordered_multimap<std::string, std::size_t> places_;  ///< of the rows, by the cells of their points
};

}  // namespace csgsim::studies
