#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "hw/base/blocked_signals.h"

namespace csgsim {

/// A folder of files that is written beside its final place and takes that as a whole, whatever ends the process: the
/// old folder is there or the new one. It has a list of its files, by which the next OutputFolder at that place knows
/// it. While it lives this thread lets no signals through. Each function throws InputError, with the path as it was
/// asked for, if it cannot do all of its work.
class OutputFolder {
 public:
  /// Fails where a file is, or a folder that is not empty and has no list or has a listed file that has been edited
  /// since; and for the current folder and those that it is in, which no other can take the place of.
  explicit OutputFolder(std::filesystem::path folder);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Writes a file of the folder, or of one in it.
  void write(const std::filesystem::path& name, std::string_view content);

  /// Puts the folder in its place. Files of the old one that are not in its list, such as what was made of those that
  /// are, are in the new one then.
  void commit();

 private:
  void exchange();
  void take_others_back();

  BlockedSignals blocked_;
  std::filesystem::path asked_;
  std::filesystem::path final_;
  std::filesystem::path partial_;  ///< the new folder; after commit() what is left of the old one
  std::string list_;               ///< of the files written: a hash and a name a line
};

}  // namespace csgsim
