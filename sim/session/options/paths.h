// Checks of input and output paths.
// Used by sim/session, sim/app, sim/shell, sim/studies and sim/viewer.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace csgsim::session {

/// Whether the path has this extension, as in `.png`, in upper or lower case.
bool has_extension(const std::filesystem::path& path, std::string_view extension);

/// The files read for models or Programs and machines. Built-in machines have no file.
std::vector<std::filesystem::path> input_files(const std::vector<std::string>& subjects,
                                               const std::vector<std::string>& machines);

/// Rejects outputs that are also inputs, or that equal another output; empty paths are ignored. Throws UsageError.
void refuse_clashes(std::span<const std::filesystem::path> inputs, std::span<const std::filesystem::path> outputs);

/// Whether the path is a stream without an extension that could select a format: `-`, /dev/stdout, most pipes.
bool is_unnamed_stream(const std::filesystem::path& path);

/// Name of an input in messages: `standard input` for `-`.
std::string shown_name(const std::string& path);

/// Throws UsageError if the picture's extension belongs to no format; an empty path is accepted.
void refuse_unknown_format(const std::string& option, const std::filesystem::path& picture);

/// Rejects binary output to a terminal. Throws UsageError.
void refuse_terminal(const std::string& option, const std::filesystem::path& path);

}  // namespace csgsim::session
