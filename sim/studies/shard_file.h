// Files that hold the measured points of shards.
// Used by shard_run.h and gather.h.
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

/// Maximum number of points of a sharded study; the joined table is read as a whole and cannot hold more.
inline constexpr std::size_t max_points = 1'000'000;

/// Identifies the study and the shard of a file.
struct ShardHeader {
  Shard shard;
  std::size_t points = 0;          ///< number of points of all shards together
  Inputs inputs;                   ///< combined inputs of all points
  std::vector<std::string> words;  ///< the study's command without options that do not affect results

  bool operator==(const ShardHeader&) const = default;
};

/// A measured point: its number in the study, from 0, and its row as in the study's table.
struct ShardLine {
  std::size_t point = 0;
  std::string row;

  bool operator==(const ShardLine&) const = default;
};

/// Content of a shard's file.
struct ShardFile {
  std::filesystem::path path;
  ShardHeader header;
  std::vector<std::string> command;  ///< arguments that repeat the run, without shard and outputs; empty in old files
  std::string columns;               ///< column names of the rows
  std::vector<ShardLine> lines;
};

/// The subfolder of a study's folder that holds the files of shards.
std::filesystem::path shards_folder(const std::filesystem::path& study);

/// All files of shards in a study's folder, sorted by name; only those of `shard` if given. Throws InputError if the
/// folder does not exist and `shard` is not given.
std::vector<std::filesystem::path> list_shard_files(const std::filesystem::path& study,
                                                    const std::optional<ShardHeader>& shard = {});

/// Reads a file; ignores a partial last line, which was interrupted or is being written. Throws InputError if the file
/// does not belong to a shard.
ShardFile read_shard_file(const std::filesystem::path& path);

/// Writes a file of a shard with a unique name in the study's folder: processes of the same shard, even on different
/// computers, each write their own file and need no lock. The file is created with the first row.
class ShardWriter {
 public:
  /// `command`: the command-line arguments that repeat the run, with options that do not affect results, as --threads.
  ShardWriter(std::filesystem::path study, ShardHeader header, std::vector<std::string> command, std::string columns);

  /// Appends a row and syncs the file. Throws InputError on failure.
  void add(const ShardLine& line);

 private:
  std::filesystem::path study_;
  ShardHeader header_;
  std::vector<std::string> command_;
  std::string columns_;
  std::optional<CsvFile> file_;
};

}  // namespace csgsim::studies
