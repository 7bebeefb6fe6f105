// Writes a folder of files atomically.
// Used by sim/app.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "hw/base/blocked_signals.h"

namespace csgsim {

/// A folder of files that is written next to its final place and moved there as a whole: whatever ends the process,
/// either the old or the new folder is in place. The folder contains a list of its files, which identifies it to the
/// next OutputFolder at that place. Signals are blocked in this thread during the object's lifetime. Each function
/// throws InputError with the requested path if it cannot do all of its work.
class OutputFolder {
 public:
  /// Throws if the path is a file, a non-empty folder without a list, or a folder in which a listed file was edited
  /// since it was written. Also throws for the current folder and its parents, which cannot be replaced.
  explicit OutputFolder(std::filesystem::path folder);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Writes a file of the folder or of one of its subfolders.
  void write(const std::filesystem::path& name, std::string_view content);

  /// Moves the folder to its place. Files of the old folder that are not in its list, such as build products of listed
  /// files, are moved to the new folder.
  void commit();

 private:
  void exchange();
  void keep_unlisted_files();

  BlockedSignals blocked_;
  std::filesystem::path requested_;
  std::filesystem::path final_;
  std::filesystem::path partial_;  ///< the new folder; after commit() the remains of the old one
  std::string list_;               ///< list of the files written: one hash and name per line
};

}  // namespace csgsim
