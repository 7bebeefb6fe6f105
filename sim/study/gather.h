#pragma once

#include <cstddef>
#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "hw/base/error.h"
#include "sim/study/inputs.h"
#include "sim/study/shard_file.h"
#include "sim/study/table.h"

namespace csgsim::study {

/// What all shards of a study have measured together.
struct Gathered {
  unsigned shards = 0;
  Inputs inputs;
  std::vector<std::string> words;  ///< the study's command, but for what changes no result
  std::string columns;
  std::vector<std::string> rows;                ///< of each point, empty where it has not been measured
  std::vector<std::filesystem::path> measured;  ///< the file that has the row of each point
  std::size_t missing = 0;                      ///< points
  std::vector<unsigned> unfinished;             ///< numbers of the shards that these belong to, ascending
  std::filesystem::path first;                  ///< one of the files, all of which are of the same command
};

/// Joins the shards in these folders, which were given to them as places for the study. Throws InputError if they are
/// of several studies, if one is in two folders, or if a point has two results.
Gathered gather(std::span<const std::filesystem::path> studies);

/// Puts the rows, of which none is missing, into a table that has none or some of them. Throws InputError if one cannot
/// be read, or if the table at the path has others. Returns the rows.
template <class Row>
const std::vector<Row>& put_rows(const Gathered& gathered, const std::filesystem::path& path, Table<Row>& table) {
  if (gathered.columns != header_of<Row>()) {
    throw InputError(path.native() +
                     ": this csgsim has other columns than the one that measured the shards; gather with " +
                     gathered.inputs.csgsim);
  }
  std::vector<Row> rows;
  for (std::size_t i = 0; i < gathered.rows.size(); ++i) {
    try {
      rows.push_back(from_line<Row>(gathered.rows[i]));
    } catch (const InputError& error) {
      throw InputError(gathered.measured[i].native() + ": point " + std::to_string(i) + ": " + error.what() +
                       "; delete the line and run the shard again");
    }
  }
  const std::set<std::string> lines(gathered.rows.begin(), gathered.rows.end());
  for (const Row& row : table.rows()) {
    if (!lines.contains(to_line(row)))
      throw InputError(path.native() + ": has points that the shards do not have; take another place with -o");
  }
  table.replace(std::move(rows));
  return table.rows();
}

}  // namespace csgsim::study
