// Completion of debugger commands.
// Used by sim/app.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace csgsim::debug {

/// Continuations of a line.
struct Completion {
  std::string insert;                   ///< common continuation of all matching words; ends with a blank if only one
                                        ///< matches
  std::vector<std::string> candidates;  ///< the matching words
};

/// Completes the last word of the text before the cursor.
Completion complete(std::string_view line, std::span<const std::string> words);

}  // namespace csgsim::debug
