#pragma once

#include <string_view>

namespace csgsim {

/// Writes to standard error as it is; where that cannot be written nothing happens.
void tell(std::string_view text) noexcept;

/// One line on standard error, made harmless by printable().
void tell_line(std::string_view line) noexcept;

/// Standard input, output and error that are closed are opened so that they cannot be used: a file that is opened later
/// must not take their numbers.
void keep_standard_numbers();

}  // namespace csgsim
