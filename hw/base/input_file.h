#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "hw/base/descriptor.h"

namespace csgsim {

/// What is read, for messages, and how much of it at most.
struct InputKind {
  std::string_view what;  ///< as in "name a .csg file"
  std::size_t most_bytes = 0;
  std::string_view advice;    ///< for a longer one, as in "split the model"
  bool is_continued = false;  ///< the command goes on with it: what it writes may replace it (inputs_kept.h)
};

/// All of a file, which may also be a pipe or a device; `-` is standard input, which is kept to be read again. Throws
/// InputError if it cannot be read, is longer than allowed or does not fit into memory.
std::string read_file(const std::filesystem::path& path, const InputKind& kind);

/// The same of a file whose name no person gave on a command line: what is no regular file, as a pipe or a device, is
/// refused at once, without waiting for what it has to say.
std::string read_regular_file(const std::filesystem::path& path, const InputKind& kind);

/// The parts of that. None if there is no such file, nor anything else under that name. Throws InputError if it is not
/// a regular file, or cannot be opened.
Descriptor open_regular_file(const std::filesystem::path& path, const InputKind& kind);
std::string read_file(const Descriptor& file, const std::filesystem::path& path, const InputKind& kind);

/// What read_file says of a text of so many bytes, if it is too long. Throws InputError.
void check_length(std::string_view name, std::size_t bytes, const InputKind& kind);

}  // namespace csgsim
