// Formats untrusted text, shell words and numbers for messages and tables.
// Used in all rooms.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace csgsim {

/// Untrusted bytes (file names, keys, values) as harmless text: line breaks, other control characters, characters that
/// change the writing direction, and invalid UTF-8 become `\n`, `\r`, `\t` or `\xHH`. Idempotent.
std::string printable(std::string_view bytes);

/// printable() with every backslash doubled. If a spreadsheet would read the first character as the start of a formula
/// (= + - @), it becomes `\x3d` and the like. Different names stay different; tables store names in this form.
std::string escaped(std::string_view bytes);

/// The bytes as one word of a POSIX shell, for commands that users copy from a message.
std::string shell_word(std::string_view bytes);

/// 1234567 as `1,234,567`.
std::string grouped(std::uint64_t value);

/// A number for people, rounded to `digits` significant digits; a number with more digits before the point is rounded
/// to a whole number: `24.32`, `0.00576`, `1,736`.
std::string rounded(double value, int digits = 3);

/// A quantity of a unit for people, with an SI prefix and three significant digits: `26.6 mJ`, `10 MHz`, `18.9 Mbit`.
/// Seconds have no prefix above one: `1,736 s`. Without a unit only the prefix follows the number: `6.61 G`.
std::string quantity(double value, std::string_view unit);

/// A size limit in whole KiB, MiB or GiB (`64 KiB`, `16 MiB`, `1 GiB`), rounded down.
std::string binary_size(std::uint64_t bytes);

}  // namespace csgsim
