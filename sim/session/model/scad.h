#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace csgsim::session {

inline constexpr std::chrono::seconds usual_openscad_time = std::chrono::minutes(30);

/// What the OpenSCAD that is found as a shell finds it makes of a source file: the text of a `.csg` file. Its warnings
/// go to standard error. Throws InputError if there is none, with what it says of an error, or if it takes longer
/// than that, or more memory or output than it may.
std::string csg_of_scad(const std::string& file, std::chrono::seconds longest = usual_openscad_time);

/// The same of a text that stands in the file's place, in the file's folder; messages name the file.
std::string csg_of_scad(const std::string& file, std::string_view text,
                        std::chrono::seconds longest = usual_openscad_time);

}  // namespace csgsim::session
