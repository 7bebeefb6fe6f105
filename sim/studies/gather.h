// Joins the results of the shards of a study.
// Used by csgsim gather.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "sim/studies/inputs.h"
#include "sim/studies/shard_file.h"

namespace csgsim::studies {

/// The combined results of all shards of a study.
struct MergedShards {
  unsigned shards = 0;
  Inputs inputs;
  std::vector<std::string> words;          ///< the study's command without options that do not affect results
  std::map<unsigned, ShardFile> commands;  ///< by shard number, a file of the shard without its lines
  std::string columns;
  std::vector<std::string> rows;                ///< one per point; empty if not measured
  std::vector<std::filesystem::path> measured;  ///< file with the row of each point
  std::size_t missing = 0;                      ///< number of points without a row
  std::vector<unsigned> unfinished;             ///< numbers of the shards with missing points, ascending
  std::filesystem::path first;                  ///< one of the files; all have the same command
};

/// Joins the shards in these study folders. Throws InputError if they belong to several studies, if a shard is in two
/// folders, or if a point has two different results.
MergedShards merge_shards(std::span<const std::filesystem::path> studies);

}  // namespace csgsim::studies
