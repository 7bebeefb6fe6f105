#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "hw/base/descriptor.h"

namespace csgsim::read {

/// A place that a name leads to from one of the folders.
struct ImportPlace {
  std::filesystem::path path;
  bool is_inside = false;  ///< in one of the folders or below it, by the names alone

  /// Whether a file, or anything else, is there. Also where the system does not let this be found out.
  [[nodiscard]] bool exists() const;
};

/// Where the files that a model imports may be: in the model's folder, in another one that is named, and below them.
class ImportFolders {
 public:
  /// `named`: see read::Options.
  ImportFolders(const std::filesystem::path& model_folder, const std::filesystem::path& named);

  /// The places where a file of that name is looked for, in order.
  [[nodiscard]] std::vector<ImportPlace> places_of(std::string_view name) const;

  /// Whether what was opened is in one of the folders, whatever links led to it. Throws InputError if the system does
  /// not tell.
  [[nodiscard]] bool hold(const Descriptor& file) const;

 private:
  std::vector<std::filesystem::path> folders_;
};

}  // namespace csgsim::read
