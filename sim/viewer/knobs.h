// Names of the settings that the page can change.
// Used by sim/viewer and sim/app.
#pragma once

#include <array>
#include <string_view>

namespace csgsim::viewer {

/// Settings that the page can change: options of `csgsim render` by their long names, except those that name files or
/// limit the work.
inline constexpr auto knobs = std::to_array<std::string_view>(
    {"camera",      "projection",    "view-all",  "near",          "size",     "machine",    "memory-bits",
     "set",         "colour-scheme", "tolerance", "curves",        "strategy", "stack-bits", "colouring",
     "colour-bits", "pruning",       "z-bits",    "fraction-bits", "edge-on",  "snap"});

}  // namespace csgsim::viewer
