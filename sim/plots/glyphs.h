#pragma once

#include <string>
#include <string_view>

namespace csgsim::plots {

/// The text as letters of this machine's fonts can show it: printable, with a question mark for each character that no
/// font has. Cairo would draw such a one as a box of its code, under gnuplot's scale larger than the picture. Which
/// characters there are fontconfig's `fc-list` tells, once a process, and only when a text is not plain ASCII; where it
/// cannot be run all are taken to be there.
std::string with_glyphs(std::string_view text);

}  // namespace csgsim::plots
