// Messages of OpenSCAD.
// Used by scad.cpp.
#pragma once

#include <string>
#include <string_view>

namespace csgsim::session {

/// Prints what OpenSCAD wrote to standard error about the source `file`, line by line, except its first error: see
/// scad_error(). A loop can repeat a message thousands of times, so the first ones of each kind are printed and the
/// rest are counted.
void print_scad_messages(std::string_view output, const std::string& file);

/// The first error in `output`, as `file:line: message` where OpenSCAD gives a place; empty if there is none. OpenSCAD
/// 2021.01 exits successfully after a failed assert().
std::string scad_error(std::string_view output, const std::string& file);

}  // namespace csgsim::session
