#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace csgsim::shell {

/// The command line asks for what makes no sense; what() says why in one line.
class UsageError : public std::runtime_error {
 public:
  explicit UsageError(const std::string& message) : std::runtime_error(message) {}
  UsageError(const std::string& option, const std::string& message) : UsageError(option + ": " + message) {}
};

struct KnownCommand {
  std::string name;
  std::vector<std::string> options;  ///< long names, with dashes
};

/// One line for people about a command line that could not be read, for the reason given; unknown commands and options
/// name the nearest known one.
std::string explain(std::span<const KnownCommand> commands, std::string_view reason, std::span<char* const> arguments);

}  // namespace csgsim::shell
