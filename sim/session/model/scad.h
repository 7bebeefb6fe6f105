// Runs OpenSCAD on a model's source.
// Used by sim/session and sim/web.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace csgsim::session {

inline constexpr std::chrono::seconds default_openscad_time = std::chrono::minutes(30);

/// Evaluates a source file with the OpenSCAD on the PATH and returns the text of a `.csg` file. Warnings go to standard
/// error. Throws InputError if OpenSCAD is missing, reports an error, or exceeds its limits of time, memory or output.
std::string evaluate_scad(const std::string& file, std::chrono::seconds time_limit = default_openscad_time);

/// Evaluates a text that replaces the file's content, in the file's folder; messages name the file.
std::string evaluate_scad(const std::string& file, std::string_view text,
                          std::chrono::seconds time_limit = default_openscad_time);

}  // namespace csgsim::session
