#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <span>
#include <string>

#include "hw/base/folder_lock.h"
#include "hw/base/output_file.h"

namespace csgsim::app {

/// The folder that a study writes to: made if it is not there, and kept for this process as long as the object lives.
class StudyFolder {
 public:
  /// Throws InputError if it cannot be, if another process writes there, and CLI::ValidationError if something that is
  /// read has a name there that a study writes to.
  StudyFolder(const std::filesystem::path& folder, const std::string& study,
              std::span<const std::filesystem::path> inputs);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  FolderLock lock_;
};

/// `csgsim STUDY` with the options that are not as they are by default, but for those named and those that change no
/// result (the output, threads, progress, plots): tells what a table is of.
std::string study_title(const CLI::App& command, const std::set<std::string>& but);

/// Tells on standard error what has changed since some rows of a table were measured.
void tell_stale(const std::filesystem::path& table, const std::set<std::string>& changed);

/// Writes the points of a study: row_json(row) of each. Throws InputError.
template <class Rows, class RowJson>
void write_points(const std::filesystem::path& path, const std::string& title, const Rows& rows,
                  const RowJson& row_json) {
  nlohmann::ordered_json json{{"study", title}, {"points", nlohmann::ordered_json::array()}};
  for (const auto& row : rows) json["points"].push_back(row_json(row));
  write_file(path, json.dump(2) + "\n");
}

}  // namespace csgsim::app
