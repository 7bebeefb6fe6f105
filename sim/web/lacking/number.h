#pragma once

#include <charconv>

namespace csgsim::web {

/// What std::from_chars does of a number in decimals, which libc++ 19 has not.
std::from_chars_result read_number(const char* first, const char* last, double& value);
std::from_chars_result read_number(const char* first, const char* last, float& value);

}  // namespace csgsim::web
