#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

/// Files and texts from outside, as stats files have them.
namespace csgsim::session {

/// The hash of the bytes of a file; null of what can be read only once, as a pipe is. Throws InputError.
nlohmann::ordered_json hash_of_file(const std::filesystem::path& file);

/// Bytes from outside, as JSON can hold them: those that are no plain text are {"hex": "..."}.
nlohmann::ordered_json bytes_json(const std::string& bytes);

/// The same back. Throws InputError where it is neither.
std::string bytes_of(const nlohmann::ordered_json& json);

}  // namespace csgsim::session
