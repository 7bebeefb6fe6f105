#pragma once

#include <string>

namespace csgsim::app {

/// What the OpenSCAD that is found as a shell finds it makes of a source file: the text of a `.csg` file. Its warnings
/// go to standard error. Throws InputError if there is none, or with what it says of an error.
std::string csg_of_scad(const std::string& file);

}  // namespace csgsim::app
