#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

#include "hw/base/descriptor.h"

namespace csgsim::system {

/// A file that is in memory only: for libraries and programs that write to files without telling whether it worked. No
/// disk can be full under it; a limit on the size of files (ulimit -f) holds for it too. Linux only. Each function
/// throws InputError that begins with the purpose.
class MemoryFile {
 public:
  /// `purpose` is the file that its content is for, in messages. Throws if the system has none to give.
  explicit MemoryFile(std::filesystem::path purpose);

  /// A name by which this process can open it, for reading or writing.
  [[nodiscard]] std::string path() const;

  [[nodiscard]] const Descriptor& descriptor() const { return descriptor_; }

  /// Writes the bytes at its place, and goes back to its beginning.
  void write(std::string_view bytes);

  /// Writes the bytes at its place, and stays behind them.
  void append(std::string_view bytes);

  /// Goes back to its beginning.
  void rewind() const;

  /// All that was written. Throws if it cannot be read, or if a limit on the size of files has refused any write of
  /// this process since this file was made, so that something may be missing.
  [[nodiscard]] std::string content() const;

 private:
  [[noreturn]] void fail(const std::error_code& error) const;

  std::filesystem::path purpose_;
  Descriptor descriptor_;
  unsigned refused_before_ = 0;
};

}  // namespace csgsim::system
