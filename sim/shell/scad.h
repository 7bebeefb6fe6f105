#pragma once

#include <string>
#include <string_view>

#include "sim/shell/command_line.h"

namespace csgsim::shell {

/// Adds --openscad-time: how long OpenSCAD may take for each source of this process.
void add_openscad_time(Command& command);

/// What the OpenSCAD that is found as a shell finds it makes of a source file: the text of a `.csg` file. Its warnings
/// go to standard error. Throws InputError if there is none, with what it says of an error, or if it takes more time,
/// memory or output than it may.
std::string csg_of_scad(const std::string& file);

/// The same of a text that stands in the file's place, in the file's folder; messages name the file.
std::string csg_of_scad(const std::string& file, std::string_view text);

}  // namespace csgsim::shell
