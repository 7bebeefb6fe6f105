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

/// A point that is asked for: the first cells of its row, as the table has them, and what it is measured from.
struct Asked {
  std::string cells;
  Inputs inputs;
};

/// Whether a row of the point with that number, measured from the same inputs, tells all that is asked for now.
using Serves = std::function<bool(std::size_t point, const std::string& row)>;

inline bool serves_all(std::size_t /*point*/, const std::string& /*row*/) { return true; }

/// The rows of a study, as lines; kept in a CSV file that grows by a line a point, if it has one.
class Table {
 public:
  /// Without a file.
  explicit Table(RowFormat format, Serves serves = serves_all)
      : format_(std::move(format)), serves_(std::move(serves)) {}

  /// Opens or begins a table. Throws InputError if the file holds another study (another `title`) or no table.
  Table(const std::filesystem::path& path, const std::string& title, RowFormat format, Serves serves = serves_all);

  [[nodiscard]] const std::vector<std::string>& rows() const { return rows_; }

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

  RowFormat format_;
  Serves serves_;
  std::filesystem::path path_;
  std::optional<CsvFile> file_;
  std::vector<std::string> rows_;
  std::unordered_multimap<std::string, std::size_t> places_;  ///< of the rows, by the cells of their points
};

}  // namespace csgsim::studies
