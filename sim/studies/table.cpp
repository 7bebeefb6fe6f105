#include "sim/studies/table.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "hw/base/error.h"

namespace csgsim::studies {

namespace {

/// The inputs that a row was measured from. The row must have been checked.
Inputs inputs_of(const std::string& row, std::size_t point_columns) {
  const std::vector<std::string> cells = split_cells(row);
  return {cells.at(point_columns), cells.at(point_columns + 1), cells.at(point_columns + 2)};
}

}  // namespace

Table::Table(const std::filesystem::path& path, const std::string& title, RowFormat format, HasRequestedResults serves)
    : format_(std::move(format)),
      serves_(std::move(serves)),
      path_(path),
      file_(open_study_table(path, title, format_.columns)) {
  for (std::size_t i = 0; i < file_->existing_lines().size(); ++i) {
    try {
      format_.check(file_->existing_lines()[i]);
    } catch (const InputError& error) {
      file_->reject_line(i, error.what());
    }
  }
  store(file_->existing_lines());
}

std::string Table::point_of(const std::string& row) const {
  return std::string(first_cells(row, format_.point_columns));
}

bool Table::has_inputs(const std::string& row, const PointRequest& requested) const {
  return row.starts_with(requested.cells + "," + to_line(requested.inputs) + ",");
}

void Table::store(std::vector<std::string> rows) {
  rows_ = std::move(rows);
  places_.clear();
  for (std::size_t i = 0; i < rows_.size(); ++i) places_.emplace(point_of(rows_[i]), i);
}

std::set<std::string> Table::drop_stale(std::span<const PointRequest> requested, bool is_of_one_machine) {
  std::unordered_map<std::string, const PointRequest*> now;
  for (const PointRequest& one : requested) now.emplace(one.cells, &one);
  std::set<std::string> changed;
  std::vector<std::string> kept;
  for (const std::string& row : rows_) {
    const auto same = now.find(point_of(row));
    const PointRequest* const known = same != now.end()                         ? same->second
                                      : is_of_one_machine && !requested.empty() ? &requested.front()
                                                                                : nullptr;
    const std::vector<std::string> names = known == nullptr
                                               ? std::vector<std::string>{}
                                               : changed_inputs(inputs_of(row, format_.point_columns), known->inputs);
    if (names.empty()) kept.push_back(row);
    changed.insert(names.begin(), names.end());
  }
  if (kept.size() == rows_.size()) return changed;
  if (file_) file_->replace(kept);
  store(std::move(kept));
  return changed;
}

const std::string* Table::find(std::span<const PointRequest> requested, std::size_t point) const {
  const auto [begin, end] = places_.equal_range(requested[point].cells);
  for (auto place = begin; place != end; ++place) {
    const std::string& row = rows_[place->second];
    if (has_inputs(row, requested[point]) && serves_(point, row)) return &row;
  }
  return nullptr;
}

std::vector<std::size_t> Table::missing(std::span<const PointRequest> requested) const {
  std::vector<std::size_t> points;
  for (std::size_t i = 0; i < requested.size(); ++i) {
    if (find(requested, i) == nullptr) points.push_back(i);
  }
  return points;
}

void Table::add(std::span<const std::string> rows) {
  if (rows.empty()) return;
  std::string lines;
  for (const std::string& row : rows) lines += (lines.empty() ? "" : "\n") + row;
  if (file_) file_->append(lines);
  for (const std::string& row : rows) {
    places_.emplace(point_of(row), rows_.size());
    rows_.push_back(row);
  }
}

std::vector<std::string> Table::ordered_rows(std::span<const PointRequest> requested) {
  std::vector<std::string> rows;
  std::unordered_set<std::string> points;
  for (std::size_t i = 0; i < requested.size(); ++i) {
    rows.push_back(*find(requested, i));
    points.insert(requested[i].cells);
  }
  if (!file_) return rows;
  std::vector<std::string> all = rows;
  for (const std::string& row : rows_) {
    if (!points.contains(point_of(row))) all.push_back(row);
  }
  if (all != rows_) {
    file_->replace(all);
    store(std::move(all));
  }
  return rows;
}

std::vector<std::string> Table::put(const MergedShards& gathered) {
  if (gathered.columns != format_.columns) {
    throw InputError(
        path_.native() +
        ": this csgsim writes other columns than the version that measured the shards; gather with version " +
        gathered.inputs.csgsim);
  }
  for (std::size_t i = 0; i < gathered.rows.size(); ++i) {
    try {
      format_.check(gathered.rows[i]);
    } catch (const InputError& error) {
      throw InputError(gathered.measured[i].native() + ": point " + std::to_string(i) + ": " + error.what() +
                       "; delete the line and run the shard again");
    }
  }
  const std::unordered_set<std::string> lines(gathered.rows.begin(), gathered.rows.end());
  for (const std::string& row : rows_) {
    if (!lines.contains(row))
      throw InputError(path_.native() + ": has points that the shards lack; choose another folder with -o");
  }
  if (file_) file_->replace(gathered.rows);
  store(gathered.rows);
  return gathered.rows;
}

}  // namespace csgsim::studies
