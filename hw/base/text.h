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

/// A size limit in whole KiB, MiB or GiB (`64 KiB`, `16 MiB`, `1 GiB`), rounded down.
std::string binary_size(std::uint64_t bytes);

}  // namespace csgsim
