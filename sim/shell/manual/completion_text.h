#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace csgsim::shell {

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

/// Words with blanks between them; those inside a word have a backslash, which all shells understand.
inline std::string listed(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) {
    if (!list.empty()) list += ' ';
    for (const char letter : word) list += letter == ' ' ? "\\ " : std::string(1, letter);
  }
  return list;
}

}  // namespace csgsim::shell
