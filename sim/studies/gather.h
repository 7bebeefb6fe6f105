#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "sim/studies/inputs.h"
#include "sim/studies/shard_file.h"

namespace csgsim::studies {

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

}  // namespace csgsim::studies
