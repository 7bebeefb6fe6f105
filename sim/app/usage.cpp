#include "sim/app/usage.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "hw/base/nearest.h"

namespace csgsim::app {

namespace {

/// The subcommand that the arguments begin with, if they do.
CLI::App* command_of(CLI::App& app, std::span<char* const> arguments) {
  if (arguments.size() < 2) return nullptr;
  const std::string name = arguments[1];
  for (CLI::App* command : app.get_subcommands({})) {
    if (command->get_name() == name) return command;
  }
  return nullptr;
}

std::vector<std::string> option_names(CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

/// A question after a blank, or nothing where no known word is like it.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
  const std::vector<std::string_view> candidates(known.begin(), known.end());
  const std::string_view nearest = nearest_alike(word, candidates);
  return nearest.empty() ? "" : fmt::format(" did you mean {}?", nearest);
}

}  // namespace

std::string explain(CLI::App& app, const CLI::ParseError& error, std::span<char* const> arguments) {
  CLI::App* const command = command_of(app, arguments);
  if (command == nullptr) {
    if (arguments.size() < 2) return "a subcommand is required; see csgsim --help";
    std::vector<std::string> known;
    for (const CLI::App* one : app.get_subcommands({})) known.push_back(one->get_name());
    return fmt::format("there is no command '{}';{} See csgsim --help", arguments[1],
                       did_you_mean(arguments[1], known));
  }
  const std::string help = fmt::format("see csgsim {} --help", command->get_name());
  const std::vector<std::string> known = option_names(*command);
  for (const char* argument : arguments.subspan(2)) {
    const std::string word = std::string(argument).substr(0, std::string_view(argument).find('='));
    const bool unknown = word.starts_with("--") && std::find(known.begin(), known.end(), word) == known.end();
    if (unknown) return fmt::format("there is no option {};{} {}", word, did_you_mean(word, known), help);
  }
  return fmt::format("{}; {}", error.what(), help);
}

}  // namespace csgsim::app
