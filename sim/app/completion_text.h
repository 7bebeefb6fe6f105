#pragma once

#include <string>
#include <string_view>

namespace csgsim::app {

/// As one word in single quotes, each of which inside is written as `inside`: '\'' in sh, \' in fish.
inline std::string quoted(std::string_view text, std::string_view inside) {
  std::string word = "'";
  for (const char letter : text) {
    if (letter == '\'') {
      word += inside;
    } else {
      word += letter == '\n' ? ' ' : letter;
    }
  }
  return word + "'";
}

}  // namespace csgsim::app
