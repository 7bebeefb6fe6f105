#pragma once

#include <string>
#include <vector>

namespace csgsim::testing::cli {

/// Lines of a text without their ends.
std::vector<std::string> lines_of(const std::string& text);

/// Commands as `csgsim --help` lists them.
std::vector<std::string> commands();

/// How a command's help begins the lines of its options: `-o, --output FILE`.
std::vector<std::string> option_heads(const std::string& command);

}  // namespace csgsim::testing::cli
