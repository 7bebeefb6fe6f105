#include "sim/shell/manual/describe_app.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>

#include "sim/shell/version.h"

namespace csgsim::shell {

namespace {

/// What a check of that name tells of itself; empty if there is none.
std::string told_by(CLI::Option& option, const char* check) {
  try {
    return option.get_validator(check)->get_description();
  } catch (const CLI::OptionNotFound&) {
    return {};
  }
}

/// Of `one, two`.
std::vector<std::string> words_in(std::string_view text) {
  constexpr std::string_view separator = ", ";
  std::vector<std::string> words;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(separator), text.size());
    words.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + separator.size(), text.size()));
  }
  return words;
}

OptionHelp help_of_option(CLI::Option& option) {
  OptionHelp help;
  if (option.get_positional()) {
    help.names.push_back(option.get_name());
  } else {
    for (const std::string& name : option.get_snames()) help.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) help.names.push_back("--" + name);
  }
  const std::string type = option.get_type_name();
  help.type = option.get_items_expected_max() == 0 ? "" : type.substr(0, type.find(':'));
  help.meaning = option.get_description();
  help.words = words_in(told_by(option, words_check));
  help.range = told_by(option, range_check);
  help.usual = option.get_default_str();
  help.is_needed = option.get_required();
  help.takes_several = option.get_items_expected_max() > 1;
  return help;
}

}  // namespace

CommandHelp help_of_command(CLI::App& command) {
  CommandHelp help{command.get_name(), command.get_description(), command.get_footer(), {}, {}};
  for (CLI::Option* const option : command.get_options()) {
    if (option->get_group() == hidden_group) continue;
    (option->get_positional() ? help.operands : help.options).push_back(help_of_option(*option));
  }
  return help;
}

Description describe(CLI::App& app) {
  CommandHelp program = help_of_command(app);
  Description description{program.name, program.meaning, version(), date_of_sources(), std::move(program.options), {}};
  for (CLI::App* const command : app.get_subcommands({})) description.commands.push_back(help_of_command(*command));
  return description;
}

}  // namespace csgsim::shell
