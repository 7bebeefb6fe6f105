#include "sim/shell/usage.h"

#include <fmt/format.h>

#include <algorithm>

#include "hw/base/nearest.h"

namespace csgsim::shell {

namespace {

/// A question after a blank, or nothing where no known word is like it.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
  const std::vector<std::string_view> candidates(known.begin(), known.end());
  const std::string_view nearest = nearest_alike(word, candidates);
  return nearest.empty() ? "" : fmt::format(" did you mean {}?", nearest);
}

std::string explain_command(std::span<const KnownCommand> commands, std::string_view word) {
  std::vector<std::string> known;
  for (const KnownCommand& command : commands) known.push_back(command.name);
  return fmt::format("there is no command '{}';{} see csgsim --help", word, did_you_mean(word, known));
}

}  // namespace

std::string explain(std::span<const KnownCommand> commands, std::string_view reason, std::span<char* const> arguments) {
  if (arguments.size() < 2) return "a subcommand is required; see csgsim --help";
  const std::string_view first = arguments[1];
  const auto command =
      std::find_if(commands.begin(), commands.end(), [&](const KnownCommand& one) { return one.name == first; });
  if (command == commands.end() && first.starts_with('-'))
    return fmt::format("there is no option {};{} see csgsim --help", first,
                       did_you_mean(first, {"--help", "--version"}));
  if (command == commands.end()) return explain_command(commands, first);
  const std::string help = fmt::format("see csgsim {} --help", command->name);
  const std::vector<std::string>& known = command->options;
  for (const std::string_view argument : arguments.subspan(2)) {
    if (argument == "--") break;
    const std::string_view word = argument.substr(0, argument.find('='));
    const bool unknown = word.starts_with("--") && std::find(known.begin(), known.end(), word) == known.end();
    if (unknown) return fmt::format("there is no option {};{} {}", word, did_you_mean(word, known), help);
  }
  return fmt::format("{}; {}", reason, help);
}

}  // namespace csgsim::shell
