// Bytes and hashes of files in JSON.
// Used by sim/session and sim/shell.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

/// Files and texts from outside, as stored in stats files.
namespace csgsim::session {

/// Hash of a file's bytes; null for files that can be read only once, such as pipes. Throws InputError.
nlohmann::ordered_json hash_of_file(const std::filesystem::path& file);

/// Bytes from outside as JSON: a string if they are printable text, otherwise {"hex": "..."}.
nlohmann::ordered_json bytes_json(const std::string& bytes);

/// The bytes that bytes_json() stored. Throws InputError if the JSON has neither form.
std::string bytes_from_json(const nlohmann::ordered_json& json);

}  // namespace csgsim::session
