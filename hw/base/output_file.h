#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <system_error>

#include "hw/base/descriptor.h"
#include "hw/base/partial_files.h"

namespace csgsim {

/// A file being written beside its final place, so that nobody ever sees part of it. It is deleted unless committed.
/// Symbolic links are followed; what goes to a device or a pipe is written elsewhere, and copied to it when committed.
/// Standard output, which `-` names too, belongs to the file from then on: take_standard_output(). A terminal is not
/// given binary data.
/// Each function throws InputError, with the path as it was asked for, if it cannot do all of its work: what was at the
/// final place is still there then, whole.
class OutputFile {
 public:
  /// Fails too for a folder, a file that must not be written, and a name that cannot be.
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// The place as it was asked for.
  [[nodiscard]] const std::filesystem::path& asked() const { return asked_; }

  /// Adds to what has been written.
  void write(std::string_view content);

  /// Sees to it that all of it is on the disk. Nothing can be written after that.
  void finish();

  /// Finishes it and puts it in its final place.
  void commit();

 private:
  void create(const std::filesystem::path& folder);
  void copy_to_stream();

  std::filesystem::path asked_;
  std::filesystem::path final_;
  bool is_stream_ = false;  ///< a device or a pipe, which no file may replace
  std::filesystem::path partial_;
  std::optional<PartialFile> registered_;
  Descriptor file_;
  Descriptor standard_output_;  ///< if it is the one that is written to
  bool is_finished_ = false;
};

/// Is it something to write to that is not a file of its own: standard output (`-`), a device, a pipe? Throws
/// InputError for a folder.
bool is_stream(const std::filesystem::path& path);

/// Throws InputError that says why a file cannot be written, and what to look at.
[[noreturn]] void fail_to_write(const std::filesystem::path& path, const std::error_code& error);

/// Puts all files that there are in their places, none of them before all are finished. Throws InputError.
void commit_all(std::span<OutputFile* const> files);

/// Writes a whole file, or none. Throws InputError.
void write_file(const std::filesystem::path& path, std::string_view content);

/// What the path's symbolic links lead to, there or not. Throws InputError where they lead in a circle.
std::filesystem::path without_links(const std::filesystem::path& path);

}  // namespace csgsim
