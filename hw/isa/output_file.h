#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "hw/isa/partial_files.h"

namespace csgsim {

/// A file being written beside its final place, so that nobody ever sees part of it. It is deleted unless committed.
/// Symbolic links are followed; what goes to a device or a pipe is written elsewhere, and copied to it when committed.
class OutputFile {
 public:
  /// Throws InputError if nothing can be written there.
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Where to write: an empty file whose name has the final path's extension.
  [[nodiscard]] const std::filesystem::path& path() const { return partial_; }

  /// The place as it was asked for.
  [[nodiscard]] const std::filesystem::path& asked() const { return asked_; }

  /// Takes the whole content. Throws InputError if that cannot be done.
  void write(std::string_view content) const;

  /// Puts the file in its final place. Throws InputError if that cannot be done.
  void commit();

 private:
  void copy_to_stream() const;

  std::filesystem::path asked_;
  std::filesystem::path final_;
  bool is_stream_ = false;  ///< a device or a pipe, which no file may replace
  std::filesystem::path partial_;
  std::optional<PartialFile> registered_;
};

/// Writes a whole file, or none. Throws InputError.
void write_file(const std::filesystem::path& path, std::string_view content);

}  // namespace csgsim
