#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

namespace csgsim {

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

/// From now on a signal that ends the process (an interrupt, a hang-up, a request to terminate, a broken pipe) first
/// deletes all partial files. Signals that are ignored stay ignored.
void delete_partial_files_on_signals();

}  // namespace csgsim
