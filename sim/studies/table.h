// The table of a study's rows.
// Used by the runner.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "sim/studies/csv.h"
#include "sim/studies/gather.h"
#include "sim/studies/inputs.h"
#include "sim/studies/row_text.h"

namespace csgsim::studies {

/// A requested point: the leading cells of its row, which identify it, and its inputs.
struct PointRequest {
  std::string cells;
  Inputs inputs;
};

/// Whether a row of the point with this number, measured from the same inputs, has all results that are requested now.
using HasRequestedResults = std::function<bool(std::size_t point, const std::string& row)>;

inline bool accept_any_row(std::size_t /*point*/, const std::string& /*row*/) { return true; }

/// The rows of a study as lines, optionally stored in a CSV file that grows by a line per point.
class Table {
 public:
  /// A table without a file.
  explicit Table(RowFormat format, HasRequestedResults serves = accept_any_row)
      : format_(std::move(format)), serves_(std::move(serves)) {}

  /// Opens or creates a table. Throws InputError if the file holds another study (another `title`) or is not a table.
  Table(const std::filesystem::path& path, const std::string& title, RowFormat format,
        HasRequestedResults serves = accept_any_row);

  [[nodiscard]] const std::vector<std::string>& rows() const { return rows_; }

  /// Deletes rows of these points that were measured from outdated inputs; if the table holds points of one model on
  /// one machine, all such rows. Returns the names of the inputs that changed.
  std::set<std::string> drop_stale(std::span<const PointRequest> requested, bool is_of_one_machine);

  /// Numbers of the points without a row.
  [[nodiscard]] std::vector<std::size_t> missing(std::span<const PointRequest> requested) const;

  /// Appends rows and syncs the file.
  void add(std::span<const std::string> rows);

  /// Returns the rows of these points in their order; none may be missing. Reorders the table in the same
  /// way, with the rows of other points at the end.
  std::vector<std::string> ordered_rows(std::span<const PointRequest> requested);

  /// Stores and returns the rows measured by shards; none may be missing. Throws InputError if a row cannot be read, or
  /// if the table has rows that the shards lack.
  std::vector<std::string> put(const MergedShards& gathered);

 private:
  [[nodiscard]] std::string point_of(const std::string& row) const;
  [[nodiscard]] bool has_inputs(const std::string& row, const PointRequest& requested) const;
  /// The row with the results of the requested point of that index; null if there is none.
  [[nodiscard]] const std::string* find(std::span<const PointRequest> requested, std::size_t point) const;
  void store(std::vector<std::string> rows);

  RowFormat format_;
  HasRequestedResults serves_;
  std::filesystem::path path_;
  std::optional<CsvFile> file_;
  std::vector<std::string> rows_;
  std::unordered_multimap<std::string, std::size_t> places_;  ///< indices of rows, by the cells of their points
};

}  // namespace csgsim::studies
