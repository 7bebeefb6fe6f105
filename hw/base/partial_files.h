// Deletes unfinished files when a signal ends the process.
// Used by OutputFile, sim/app and sim/system.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string_view>

namespace csgsim {

/// A file name with the given ending that is unique in this process, on this computer, and on other computers that
/// share the folder.
std::filesystem::path unique_file_name(std::string_view ending = {});

/// Registers a file for deletion if a signal ends the process during the object's lifetime.
class PartialFile {
 public:
  explicit PartialFile(const std::filesystem::path& path);
  ~PartialFile();
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;

 private:
  std::optional<std::size_t> slot_;
};

/// Installs handlers that delete all registered files before a catchable signal ends the process (interrupt, CPU time
/// or file size limit, broken pipe, alarm, ...). Ignored signals stay ignored.
void delete_partial_files_on_signals();

}  // namespace csgsim
