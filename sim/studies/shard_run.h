#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/studies/shard_file.h"

namespace csgsim::studies {

/// A process's share of a study.
class ShardRun {
 public:
  /// Reads what was measured before; what that was measured from and has changed since is told, and measured anew.
  /// Throws InputError if the folder holds another study.
  ShardRun(std::filesystem::path folder, ShardHeader header, std::string columns);

  /// Numbers of the shard's points that have to be measured.
  [[nodiscard]] const std::vector<std::size_t>& missing() const { return missing_; }

  /// Of all points of the shard.
  [[nodiscard]] std::size_t points() const { return points_; }

  void add(std::size_t point, std::string row) { writer_.add({point, std::move(row)}); }

  /// Says on standard output what is there now.
  void print() const;

 private:
  std::filesystem::path folder_;
  ShardHeader header_;
  ShardWriter writer_;
  std::size_t points_ = 0;
  std::vector<std::size_t> missing_;
};

}  // namespace csgsim::studies
