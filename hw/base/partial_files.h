#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string_view>

namespace csgsim {

/// A name that no other file of this process or another has, on this machine or on others that share the folder, with
/// the ending.
std::filesystem::path unused_name(std::string_view ending = {});

/// A file that must not outlive this process unfinished, as long as the object lives.
class PartialFile {
 public:
  explicit PartialFile(const std::filesystem::path& path);
  ~PartialFile();
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;

 private:
  std::optional<std::size_t> slot_;
};

/// From now on a signal that ends the process and can be caught (an interrupt, a limit on time or on the size of files,
/// a broken pipe, an alarm, ...) first deletes all partial files. Signals that are ignored stay ignored.
void delete_partial_files_on_signals();

}  // namespace csgsim
