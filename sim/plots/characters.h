#pragma once

#include <string_view>
#include <vector>

namespace csgsim::plots {

/// The characters of a printable text, each as its bytes.
std::vector<std::string_view> characters_of(std::string_view text);

/// The number of one of them.
char32_t code_point(std::string_view character);

}  // namespace csgsim::plots
