#pragma once

#include <exception>
#include <filesystem>
#include <optional>
#include <string_view>
#include <thread>

#include "hw/base/descriptor.h"
#include "hw/base/output_file.h"
#include "hw/base/partial_files.h"

namespace csgsim {

/// A named pipe whose content goes into an output file: for a library that writes to a file of a given name without
/// telling whether it worked. All that is written into the pipe is taken, whether or not the file can hold it.
class PipeInto {
 public:
  /// The pipe's name has the ending, as in ".vcd". Throws InputError if there can be no pipe.
  PipeInto(OutputFile& file, std::string_view ending);
  ~PipeInto();
  PipeInto(const PipeInto&) = delete;
  PipeInto& operator=(const PipeInto&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// To be called when the library has closed the pipe: afterwards all is in the file. Throws InputError if it is not.
  void finish();

 private:
  void join();
  void take();

  OutputFile& file_;
  std::filesystem::path path_;
  std::optional<PartialFile> registered_;
  Descriptor source_;
  Descriptor keeper_;  ///< keeps the pipe from ending before the library opens it
  std::thread thread_;
  std::exception_ptr failure_;
};

}  // namespace csgsim
