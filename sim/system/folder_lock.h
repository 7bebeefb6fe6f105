#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "hw/base/descriptor.h"
#include "hw/base/partial_files.h"

namespace csgsim::system {

/// Keeps a folder for this process: no two write tables there at the same time. The lock ends with the object or the
/// process, however that ends.
class FolderLock {
 public:
  /// `purpose` says who this is, as in "sweep". Throws InputError that names the process that holds the folder, if one
  /// does.
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
