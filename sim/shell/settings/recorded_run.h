#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "sim/session/options/option_list.h"
#include "sim/shell/settings/settings_file.h"

namespace csgsim::shell {

/// A stats file, with the configuration of the run that it is of.
struct RecordedRun {
  std::string file;  ///< its name in messages
  nlohmann::ordered_json stats;
  nlohmann::ordered_json configuration;
};

/// Throws InputError where the file is no stats file, or has no configuration.
RecordedRun read_recorded_run(const std::string& file);

/// The same of the file's text.
RecordedRun recorded_run_of(const std::string& text, const std::string& file);

/// The command that the run was of. Throws InputError where it is none that can be run again.
std::string command_of(const RecordedRun& run);

/// What asks for the same picture and counts of a command with these options: every option as it was, but for names of
/// what was written, and what has no effect on it. Throws InputError for what is no option of the command, or no value
/// of it.
std::vector<Setting> settings_of(const RecordedRun& run, std::span<const SettableOption> options);

/// What is not as it was, for people: the version, files that were read. Throws InputError for a file that cannot be
/// read.
std::vector<std::string> changes_since(const RecordedRun& run);

/// The same of what only the run's own configuration tells: the machine, and the model with all that it includes.
std::vector<std::string> changes_between(const RecordedRun& run, const nlohmann::ordered_json& configuration);

/// Counts that are not as they were, for people, with both values; the first few of them.
std::vector<std::string> differences(const RecordedRun& run, const nlohmann::ordered_json& stats);

}  // namespace csgsim::shell
