// Reads the run recorded in a stats file and compares runs.
// Used by sim/app.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "sim/session/options/option_list.h"
#include "sim/shell/settings/settings_file.h"

namespace csgsim::shell {

/// A stats file, with the configuration of its run.
struct RecordedRun {
  std::string file;  ///< its name in messages
  nlohmann::ordered_json stats;
  nlohmann::ordered_json configuration;
};

/// Throws InputError if the file is not a stats file or has no configuration.
RecordedRun read_recorded_run(const std::string& file);

/// Reads a run from the text of a stats file. Throws InputError like read_recorded_run().
RecordedRun parse_recorded_run(const std::string& text, const std::string& file);

/// The command of the run. Throws InputError if that command cannot be repeated.
std::string recorded_command(const RecordedRun& run);

/// The settings that reproduce picture and counts with a command that has these options: every recorded option except
/// names of outputs and options without effect on the result. Throws InputError for an unknown option or an invalid
/// value.
std::vector<Setting> recorded_settings(const RecordedRun& run, std::span<const SettableOption> options);

/// Messages about what has changed since the run: the version, the input files. Throws InputError for an unreadable
/// file.
std::vector<std::string> describe_changes_since(const RecordedRun& run);

/// Messages about changes that only the configuration of the new run reveals: the machine, and the model with its
/// included files.
std::vector<std::string> describe_configuration_changes(const RecordedRun& run,
                                                        const nlohmann::ordered_json& configuration);

/// Messages about counts that differ, with both values; at most the first few.
std::vector<std::string> describe_count_differences(const RecordedRun& run, const nlohmann::ordered_json& stats);

}  // namespace csgsim::shell
