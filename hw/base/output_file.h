// Writes output files atomically.
// Used by hw/isa and sim.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <system_error>

#include "hw/base/descriptor.h"
#include "hw/base/partial_files.h"

namespace csgsim {

/// A file that is written next to its final place and moved there by commit(), so that no reader sees part of it. It is
/// deleted unless committed. Symbolic links are followed. Data for a device or a pipe goes to a temporary file, which
/// commit() copies. Standard output, also named `-`, is reserved for the file by reserve_standard_output(). Binary data
/// is not written to a terminal. Each function throws InputError with the requested path if it cannot do all of its
/// work; the previous content of the final place is then still intact.
class OutputFile {
 public:
  /// Also throws if the path is a folder, a file without write permission or an invalid name.
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// The path as requested, before links are followed.
  [[nodiscard]] const std::filesystem::path& requested() const { return requested_; }

  /// Appends to the content.
  void write(std::string_view content);

  /// Flushes the content to the disk. Nothing can be written afterwards.
  void finish();

  /// Finishes the file and moves it to its final place.
  void commit();

 private:
  void create(const std::filesystem::path& folder);
  void copy_to_stream();

  std::filesystem::path requested_;
  std::filesystem::path final_;
  bool is_stream_ = false;  ///< a device or a pipe, which must not be replaced by a file
  std::filesystem::path partial_;
  std::optional<PartialFile> registered_;
  Descriptor file_;
  Descriptor standard_output_;  ///< open if the file goes to standard output
  bool is_finished_ = false;
};

/// Whether the path names a stream instead of a regular file: standard output (`-`), a device or a pipe. Throws
/// InputError for a folder.
bool is_stream(const std::filesystem::path& path);

/// Throws an InputError with the reason and what to check.
[[noreturn]] void fail_to_write(const std::filesystem::path& path, const std::error_code& error);

/// Commits all files as a group: flushes all, then renames all. Null pointers are skipped. Throws InputError.
void commit_all(std::span<OutputFile* const> files);

/// Writes a whole file, or nothing. Throws InputError.
void write_file(const std::filesystem::path& path, std::string_view content);

/// The target of the path's symbolic links; it need not exist. Throws InputError for a cycle of links.
std::filesystem::path resolve_links(const std::filesystem::path& path);

}  // namespace csgsim
