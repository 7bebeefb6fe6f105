#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace csgsim {

/// Bytes from outside (names of files, keys, values) as text that does no harm where people read it: line breaks, other
/// control characters, those that turn the direction of writing, and bytes that are not UTF-8 become `\n`, `\r`, `\t`
/// or `\xHH`. Doing it twice changes nothing more.
std::string printable(std::string_view bytes);

/// The same with every backslash doubled, and `\x3d` for a first character that a spreadsheet would take for a formula
/// (= + - @): different names stay different, so this is how names are stored in tables.
std::string escaped(std::string_view bytes);

/// A word that a POSIX shell reads as these bytes again, to be copied from a message.
std::string shell_word(std::string_view bytes);

/// 1234567 as `1,234,567`.
std::string grouped(std::uint64_t value);

/// A limit as people say it: whole KiB, MiB or GiB (`64 KiB`, `16 MiB`, `1 GiB`); what is left over is dropped.
std::string binary_size(std::uint64_t bytes);

}  // namespace csgsim
