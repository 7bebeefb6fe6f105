#pragma once

#include <string>

#include "hw/base/descriptor.h"

namespace csgsim {

/// A file that is in memory only: for libraries and programs that write to files without telling whether it worked. No
/// disk can be full under it. Linux only.
class MemoryFile {
 public:
  /// Throws InputError if the system has none to give.
  MemoryFile();

  /// A name by which this process can open it, for reading or writing.
  [[nodiscard]] std::string path() const;

  [[nodiscard]] const Descriptor& descriptor() const { return descriptor_; }

  /// All that was written. Throws InputError if it cannot be read, or if it is as long as a limit on files lets it be
  /// (ulimit -f), so that something may be missing.
  [[nodiscard]] std::string content() const;

 private:
  Descriptor descriptor_;
};

}  // namespace csgsim
