#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "hw/base/descriptor.h"

namespace csgsim::read {

/// Where the files that a model imports may be: in the model's folder, in another one that is named, and below them.
class ImportFolders {
 public:
  /// `named`: see read::Options.
  ImportFolders(const std::filesystem::path& model_folder, const std::filesystem::path& named);

  /// Where a file of that name is looked for, in order: what leads out of both folders is left out.
  [[nodiscard]] std::vector<std::filesystem::path> places_of(std::string_view name) const;

  /// Whether what was opened is in one of the folders, whatever links led to it. Throws InputError if the system does
  /// not tell.
  [[nodiscard]] bool hold(const Descriptor& file) const;

 private:
  std::vector<std::filesystem::path> folders_;
};

}  // namespace csgsim::read
