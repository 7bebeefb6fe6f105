// Parses floating-point numbers.
// Used by from_chars.cpp.
#pragma once

#include <charconv>

namespace csgsim::web {

/// Replacement of std::from_chars for decimal floating-point numbers, which libc++ 19 lacks.
std::from_chars_result read_number(const char* first, const char* last, double& value);
std::from_chars_result read_number(const char* first, const char* last, float& value);

}  // namespace csgsim::web
