// Folders from which a model may import files.
// Used by source.h.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "hw/base/descriptor.h"

namespace csgsim::read {

/// A path to which a file name resolves from one of the folders.
struct ImportPlace {
  std::filesystem::path path;
  bool is_inside = false;  ///< whether the path is lexically inside one of the folders

  /// Whether a file or anything else exists at the path; also true if the system denies that information.
  [[nodiscard]] bool exists() const;
};

/// The folders from which a model may import files: the model's folder, an additional one, and their subfolders.
class ImportFolders {
 public:
  /// `additional_folder` may be empty; see read::Options::imports_from.
  ImportFolders(const std::filesystem::path& model_folder, const std::filesystem::path& additional_folder);

  /// The paths at which a file with the given name is searched, in order.
  [[nodiscard]] std::vector<ImportPlace> candidate_places(std::string_view name) const;

  /// Whether an opened file is inside one of the folders after resolving all links. Throws InputError if the system
  /// does not provide its path.
  [[nodiscard]] bool contains(const Descriptor& file) const;

 private:
  std::vector<std::filesystem::path> folders_;
};

}  // namespace csgsim::read
