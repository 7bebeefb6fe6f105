// An exclusive lock on an output folder.
// Used by sim/studies.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "hw/base/descriptor.h"
#include "hw/base/partial_files.h"

namespace csgsim::system {

/// Locks a folder for this process, so that no two processes write tables there at the same time. The lock ends with
/// the object or with the process, however it ends.
class FolderLock {
 public:
  /// `purpose` names the holder, as in "sweep". Throws InputError that names the process holding the folder, if it is
  /// locked.
  FolderLock(const std::filesystem::path& folder, std::string_view purpose);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  std::filesystem::path path_;
  Descriptor file_;
  std::optional<PartialFile> registered_;
};

}  // namespace csgsim::system
