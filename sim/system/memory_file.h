// Files in memory.
// Used by sim/system, sim/pictures, sim/plots, sim/session and sim/waves.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

#include "hw/base/descriptor.h"

namespace csgsim::system {

/// A file in memory, for libraries and programs that write files without reporting errors. It cannot fail because a
/// disk is full, but a file size limit (ulimit -f) applies. Linux only. Each function throws InputError that begins
/// with the purpose.
class MemoryFile {
 public:
  /// `purpose` names, in messages, the file for which the content is intended. Throws if the system provides no files
  /// in memory.
  explicit MemoryFile(std::filesystem::path purpose);

  /// A path by which this process can open it for reading or writing.
  [[nodiscard]] std::string path() const;

  [[nodiscard]] const Descriptor& descriptor() const { return descriptor_; }

  /// Writes the bytes at the current position, and returns to the beginning.
  void write(std::string_view bytes);

  /// Appends the bytes at the current position.
  void append(std::string_view bytes);

  /// Returns to the beginning.
  void rewind() const;

  /// The whole content. Throws if it cannot be read, or if a file size limit has refused any write of this process
  /// since this file was created, so that bytes may be missing.
  [[nodiscard]] std::string content() const;

 private:
  [[noreturn]] void fail(const std::error_code& error) const;

  std::filesystem::path purpose_;
  Descriptor descriptor_;
  unsigned refused_before_ = 0;
};

}  // namespace csgsim::system
