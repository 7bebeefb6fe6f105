#pragma once

#include <string>
#include <vector>

namespace csgsim::testing::cli {

/// The lines of a text, without line ends.
std::vector<std::string> lines_of(const std::string& text);

/// The commands listed by `csgsim --help`.
std::vector<std::string> commands();

/// The first part of each option's help, such as `-o, --output FILE`.
std::vector<std::string> option_heads(const std::string& command);

}  // namespace csgsim::testing::cli
