#pragma once

#include <filesystem>
#include <optional>

namespace csgsim {

/// By which standard input can be told from other files.
inline constexpr const char* standard_input_file = "/dev/stdin";

/// From now on nothing that this process reads is replaced by what it writes: OutputFile refuses to.
void keep_inputs();

/// Says that the file has been read. Of files that read_file() reads it is known.
void keep_input(const std::filesystem::path& file);

/// The file that has been read, if the output is the same one. See find_clash().
std::optional<std::filesystem::path> kept_input(const std::filesystem::path& output);

}  // namespace csgsim
