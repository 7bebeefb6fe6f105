#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace csgsim::app {

/// A stats file, with the configuration of the run that it is of.
struct RecordedRun {
  std::string file;  ///< its name in messages
  nlohmann::ordered_json stats;
  nlohmann::ordered_json configuration;
};

/// Throws InputError where the file is no stats file, or has no configuration.
RecordedRun read_recorded_run(const std::string& file);

/// The command line, without the program, that asks for the same picture and counts: every option as it was, but for
/// names of what was written, and what has no effect on it. Throws InputError.
std::vector<std::string> words_of(const RecordedRun& run);

/// What is not as it was, for people: the version, files that were read. Throws InputError for a file that cannot be
/// read.
std::vector<std::string> changes_since(const RecordedRun& run);

/// The same of what only the run's own configuration tells: the machine, and the model with all that it includes.
std::vector<std::string> changes_between(const RecordedRun& run, const nlohmann::ordered_json& configuration);

/// Counts that are not as they were, for people, with both values; the first few of them.
std::vector<std::string> differences(const RecordedRun& run, const nlohmann::ordered_json& stats);

}  // namespace csgsim::app
