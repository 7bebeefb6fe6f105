#pragma once

#include <filesystem>
#include <string_view>

#include "hw/base/descriptor.h"

namespace csgsim {

/// The name of an input that stands for standard input, and of an output that stands for standard output. A file of
/// that name is `./-`.
inline constexpr std::string_view standard_stream = "-";

/// `-`, or a name that the system has for standard output.
bool is_standard_output(const std::filesystem::path& path);

/// Does what is written to the path appear on a terminal?
bool is_terminal(const std::filesystem::path& path);

/// Standard output for the data of an output, each time a new number for it. From now on what is printed goes to
/// standard error, so that it does not get among the data.
Descriptor take_standard_output();

/// From now on what is printed goes nowhere; what is told on standard error is not concerned.
void silence_prints();

/// Nothing of the two above has been asked for.
bool prints_to_standard_output();

/// silence_prints() was called.
bool is_silent();

}  // namespace csgsim
