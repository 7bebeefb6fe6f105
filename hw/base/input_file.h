#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace csgsim {

/// What is read, for messages, and how much of it at most.
struct InputKind {
  std::string_view what;  ///< as in "name a .csg file"
  std::size_t most_bytes = 0;
  std::string_view advice;  ///< for a longer one, as in "split the model"
};

/// All of a file, which may also be a pipe or a device; `-` is standard input, which is kept to be read again. Throws
/// InputError if it cannot be read, is longer than allowed or does not fit into memory.
std::string read_file(const std::filesystem::path& path, const InputKind& kind);

/// What read_file says of a text of so many bytes, if it is too long. Throws InputError.
void check_length(std::string_view name, std::size_t bytes, const InputKind& kind);

}  // namespace csgsim
