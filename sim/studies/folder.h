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

/// The folder that a study writes to: made if it is not there, and kept for this process as long as the object lives.
class StudyFolder {
 public:
  /// Throws InputError if it cannot be, if another process writes there, and UsageError if something that is
  /// read has a name there that a study writes to.
  StudyFolder(const std::filesystem::path& folder, const std::string& study,
              std::span<const std::filesystem::path> inputs);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  system::FolderLock lock_;
};

/// `csgsim STUDY` with the options that are not as they are by default, but for those named and those that change no
/// result (the output, threads, progress, plots): tells what a table is of.
std::string study_title(const session::OptionList& command, const std::set<std::string>& but);

/// Options of studies that change no result.
inline constexpr auto options_without_effect = std::to_array<std::string_view>(
    {"output", "threads", "progress", "no-plots", "report", "quiet", "shard", "openscad-time", "json"});

/// The reason, behind the model's name if it does not begin with that.
std::string told_of(const std::string& model, const std::string& reason);

/// The last line of a study of so many models that went on past some, which its table tells the reasons of.
std::string failed_models(std::span<const std::string> failed, std::size_t models, const std::string& table);

/// Whose fault results may be that cannot be, and the mend: csgsim's, if it has measured all of them in this process;
/// of rows that were read nobody knows.
std::string whose_fault(bool has_read_rows);

/// Tells on standard error what has changed since some rows of a table were measured.
void tell_stale(const std::filesystem::path& table, const std::set<std::string>& changed);

}  // namespace csgsim::studies
