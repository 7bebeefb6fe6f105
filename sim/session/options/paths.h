#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace csgsim::session {

/// Does the path's name end so, in small letters or capitals?
bool ends_in(const std::filesystem::path& path, std::string_view ending);

/// The files that are read for models or Programs and machines; a machine may be one that comes with csgsim.
std::vector<std::filesystem::path> input_files(const std::vector<std::string>& subjects,
                                               const std::vector<std::string>& machines);

/// Refuses outputs that are among what is read, or the same as another output; empty paths are none. Throws
/// UsageError.
void refuse_clashes(std::span<const std::filesystem::path> inputs, std::span<const std::filesystem::path> outputs);

/// A stream whose name has no ending to tell a format by: `-`, /dev/stdout, most pipes.
bool is_unnamed_stream(const std::filesystem::path& path);

/// The name of an input for people: `standard input` for `-`.
std::string shown_name(const std::string& path);

/// Throws UsageError for a picture's name whose ending is that of no format; an empty one is none.
void refuse_other_format(const std::string& option, const std::filesystem::path& picture);

/// Refuses binary data on a terminal. Throws UsageError.
void refuse_terminal(const std::string& option, const std::filesystem::path& path);

}  // namespace csgsim::session
