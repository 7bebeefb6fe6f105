// Protects files that a command has read from being overwritten by its outputs.
// Used by sim/app, sim/session and OutputFile.
#pragma once

#include <filesystem>
#include <optional>

namespace csgsim {

/// The path under which standard input is compared with other files.
inline constexpr const char* standard_input_file = "/dev/stdin";

/// Protects all inputs read from now on: OutputFile refuses to replace them.
void protect_inputs();

/// Records a file as read. read_file() records its files automatically.
void record_input(const std::filesystem::path& file);

/// The recorded input that is the same file as `output`, if any. See find_clash().
std::optional<std::filesystem::path> recorded_input(const std::filesystem::path& output);

}  // namespace csgsim
