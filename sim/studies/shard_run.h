// Measurement of one shard by one process.
// Used by the runner.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/studies/shard_file.h"

namespace csgsim::studies {

/// The share of a study that this process measures.
class ShardRun {
 public:
  /// Reads the points measured before. Points whose inputs have changed are reported and measured again. Throws
  /// InputError if the folder holds another study. `command`: see ShardFile::command.
  ShardRun(std::filesystem::path folder, ShardHeader header, std::vector<std::string> command, std::string columns);

  /// Numbers of the shard's points that remain to be measured.
  [[nodiscard]] const std::vector<std::size_t>& missing() const { return missing_; }

  /// Number of points of the shard.
  [[nodiscard]] std::size_t points() const { return points_; }

  /// Writes the row of a measured point. Throws InputError on failure.
  void add(std::size_t point, std::string row) { writer_.add({point, std::move(row)}); }

  /// Prints the state of the shard on standard output.
  void print() const;

 private:
  std::filesystem::path folder_;
  ShardHeader header_;
  ShardWriter writer_;
  std::size_t points_ = 0;
  std::vector<std::size_t> missing_;
};

}  // namespace csgsim::studies
