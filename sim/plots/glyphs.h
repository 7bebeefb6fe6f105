// Replaces characters that no installed font can show.
// Used by the gnuplot writer.
#pragma once

#include <string>
#include <string_view>

namespace csgsim::plots {

/// Returns the printable form of a text with a question mark for each character that no installed font has. Cairo would
/// draw such a character as a box with its code, which at gnuplot's scale is larger than the picture. The available
/// characters are read from fontconfig's `fc-list` once per process, when the first text that is not plain ASCII is
/// drawn; if `fc-list` cannot be run, all characters are assumed to be available.
std::string replace_missing_glyphs(std::string_view text);

}  // namespace csgsim::plots
