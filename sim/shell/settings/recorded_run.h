#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "sim/shell/settings/settings_file.h"

namespace csgsim::shell {

/// A stats file, with the configuration of the run that it is of.
struct RecordedRun {
  std::string file;  ///< its name in messages
  nlohmann::ordered_json stats;
  nlohmann::ordered_json configuration;
};

/// The hash of the bytes of a file; null of what can be read only once, as a pipe is. Throws InputError.
nlohmann::ordered_json hash_of_file(const std::filesystem::path& file);

/// Bytes from outside, as JSON can hold them: those that are no plain text are {"hex": "..."}.
nlohmann::ordered_json bytes_json(const std::string& bytes);

/// The same back. Throws InputError where it is neither.
std::string bytes_of(const nlohmann::ordered_json& json);

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
