#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/studies/csv.h"
#include "sim/studies/inputs.h"
#include "sim/studies/shard.h"

namespace csgsim::studies {

/// Of a study that is shared out: its table, which is read whole, has no room for more.
inline constexpr std::size_t most_points = 1'000'000;

/// What the points in a shard's file are of.
struct ShardHeader {
  Shard shard;
  std::size_t points = 0;          ///< of all shards together
  Inputs inputs;                   ///< of all points together
  std::vector<std::string> words;  ///< the study's command, but for what changes no result

  bool operator==(const ShardHeader&) const = default;
};

/// A point that has been measured: its number in the study, from 0, and its row as in the study's own table.
struct ShardLine {
  std::size_t point = 0;
  std::string row;

  bool operator==(const ShardLine&) const = default;
};

/// A file of a shard, as it was read.
struct ShardFile {
  std::filesystem::path path;
  ShardHeader header;
  std::string columns;  ///< of the rows
  std::vector<ShardLine> lines;
};

/// The folder within a study's folder where the files of its shards are.
std::filesystem::path shards_folder(const std::filesystem::path& study);

/// All files of shards in a study's folder, by name; of one study's shard only, where one is asked for. Throws
/// InputError if there is no such folder and none is asked for.
std::vector<std::filesystem::path> shard_files(const std::filesystem::path& study,
                                               const std::optional<ShardHeader>& of = {});

/// Part of a line at the end, which has been interrupted or is being written, is left out. Throws InputError for a file
/// that is none of a shard's.
ShardFile read_shard_file(const std::filesystem::path& path);

/// A file of a shard that nobody else has, in the study's folder: processes of the same shard, on whatever machines,
/// each write their own, so that none needs a lock. It is there when the first row is.
class ShardWriter {
 public:
  ShardWriter(std::filesystem::path study, ShardHeader header, std::string columns);

  /// Adds a row, and has it on the disk. Throws InputError if it cannot.
  void add(const ShardLine& line);

 private:
  std::filesystem::path study_;
  ShardHeader header_;
  std::string columns_;
  std::optional<CsvFile> file_;
};

}  // namespace csgsim::studies
