// Groups of commands: the headings of `csgsim --help`.
// Used by sim/app and sim/studies.
#pragma once

#include <string_view>

namespace csgsim::session {

inline constexpr std::string_view everyday_group = "Everyday";
inline constexpr std::string_view run_group = "Looking into a run";
inline constexpr std::string_view study_group = "Studies";
inline constexpr std::string_view hardware_group = "Hardware";

}  // namespace csgsim::session
