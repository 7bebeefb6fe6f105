#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace csgsim::debug {

/// How a line can go on.
struct Completion {
  std::string insert;                   ///< what all words that fit have next; a blank after the only one
  std::vector<std::string> candidates;  ///< the words that fit
};

/// Of the last word of a line, as it stands before the cursor.
Completion complete(std::string_view line, std::span<const std::string> words);

}  // namespace csgsim::debug
