// The output folder of a study and messages about tables.
// Used by sim/app.
#pragma once

#include <array>
#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/session/options/option_list.h"
#include "sim/system/folder_lock.h"

namespace csgsim::studies {

/// The output folder of a study: created if missing, and locked by this process for the lifetime of the object.
class StudyFolder {
 public:
  /// Throws InputError if the folder cannot be created or another process writes to it, and UsageError if an input file
  /// has the name of a file that the study may write.
  StudyFolder(const std::filesystem::path& folder, const std::string& study,
              std::span<const std::filesystem::path> inputs);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  system::FolderLock lock_;
};

/// The output folder of a study if -o is not given: MODEL-STUDY in the current folder, with the name of the model's
/// file or of the folder of models.
std::filesystem::path default_output_folder(const std::filesystem::path& model, std::string_view study);

/// `csgsim STUDY` with all options that differ from their defaults, except those in `excluded_options` and those that
/// do not affect results (output, threads, progress, plots). Identifies the content of a table.
std::string study_title(const session::OptionList& command, const std::set<std::string>& excluded_options);

/// Options of studies that do not affect results.
inline constexpr auto options_without_effect = std::to_array<std::string_view>(
    {"output", "threads", "progress", "no-plots", "report", "quiet", "shard", "openscad-time", "json"});

/// Options that name the shard or its outputs; all others are the same for every shard of a study.
inline constexpr auto options_of_shard = std::to_array<std::string_view>({"output", "report", "shard", "json"});

/// The reason, prefixed by the model's name unless it already begins with it.
std::string with_model_name(const std::string& model, const std::string& reason);

/// The last line printed by a study that skipped some of its `model_count` models; `table_name` holds the reasons.
std::string failed_models_message(std::span<const std::string> failed, std::size_t model_count,
                                  const std::string& table_name);

/// Throws for inconsistent results: std::logic_error if all rows were measured by this process, since the fault is then
/// in csgsim; InputError with a fix if rows were read, which may have been changed.
[[noreturn]] void throw_inconsistent_results(const std::string& fault, bool has_read_rows);

/// Warns on standard error about the inputs that changed since some rows of the table were measured.
void warn_stale_rows(const std::filesystem::path& table, const std::set<std::string>& changed_inputs);

}  // namespace csgsim::studies
