// Splits a file of commands into lines of words, numbers and signs.
// Used by the interpreter.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "host/read/source.h"

namespace csgsim::commands {

enum class Kind : std::uint8_t { word, number, sign };

/// A word, a number or a sign of a line.
struct Item {
  Kind kind = Kind::word;
  std::string_view text;
  double number = 0;
  std::uint32_t offset = 0;  ///< position in the text

  [[nodiscard]] bool is(std::string_view expected_text) const { return kind != Kind::number && text == expected_text; }
};

/// Splits the text into lines, without empty lines. Throws InputError for text that the grammar does not allow.
std::vector<std::vector<Item>> split_lines(read::Source& source);

}  // namespace csgsim::commands
