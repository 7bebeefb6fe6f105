#include "sim/app/describe_app.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>

#include "hw/kinds/load.h"
#include "sim/app/command_line.h"
#include "sim/app/file_options.h"
#include "sim/app/version.h"

namespace csgsim::app {

namespace {

/// What a check of that name tells of itself; empty if there is none.
std::string told_by(CLI::Option& option, const char* check) {
  try {
    return option.get_validator(check)->get_description();
  } catch (const CLI::OptionNotFound&) {
    return {};
  }
}

/// Of `{one,two}` or `one, two`.
std::vector<std::string> words_in(std::string_view text) {
  constexpr std::string_view separators = "{}, ";
  std::vector<std::string> words;
  for (std::size_t begin = text.find_first_not_of(separators); begin != std::string_view::npos;) {
    const std::size_t end = text.find_first_of(separators, begin);
    words.emplace_back(text.substr(begin, end - begin));
    begin = text.find_first_not_of(separators, std::min(end, text.size()));
  }
  return words;
}

ValueKind kind_of(const DescribedOption& option) {
  if (option.type.empty()) return ValueKind::none;
  if (!option.words.empty()) return ValueKind::words;
  std::string name = option.name;
  std::ranges::transform(name, name.begin(), [](unsigned char letter) { return std::tolower(letter); });
  switch (role_of(name)) {
    case FileRole::input:
    case FileRole::output: return ValueKind::file;
    case FileRole::machines: return ValueKind::machines;
    case FileRole::none: break;
  }
  return ValueKind::text;
}

DescribedOption describe_option(CLI::Option& option) {
  DescribedOption described;
  if (option.get_positional()) {
    described.name = option.get_name();
  } else {
    described.name = option.get_lnames().empty() ? option.get_snames().front() : option.get_lnames().front();
    for (const std::string& name : option.get_snames()) described.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) described.names.push_back("--" + name);
  }
  const bool is_flag = option.get_items_expected_max() == 0;
  const std::string type = option.get_type_name();
  described.type = is_flag ? "" : type.substr(0, type.find(':'));
  described.meaning = option.get_description();
  described.usual = is_flag ? "" : option.get_default_str();
  described.range = told_by(option, range_check);
  described.words = words_in(told_by(option, words_check));
  described.kind = kind_of(described);
  if (described.kind == ValueKind::machines) {
    for (const std::string_view name : kinds::built_in_names()) described.words.emplace_back(name);
  }
  described.is_required = option.get_required();
  described.takes_several = option.get_items_expected_max() > 1;
  return described;
}

bool is_hidden(const std::string& group) { return group.empty() || group == hidden_group; }

DescribedCommand describe_command(CLI::App& command) {
  DescribedCommand described{command.get_name(), command.get_description(), command.get_footer(), {}, {}};
  for (CLI::Option* option : command.get_options()) {
    if (is_hidden(option->get_group())) continue;
    (option->get_positional() ? described.operands : described.options).push_back(describe_option(*option));
  }
  return described;
}

}  // namespace

Description describe(CLI::App& app) {
  DescribedCommand program = describe_command(app);
  Description description{program.name, program.meaning, version(), date_of_sources(), std::move(program.options), {}};
  for (CLI::App* command : app.get_subcommands({})) {
    if (!is_hidden(command->get_group())) description.commands.push_back(describe_command(*command));
  }
  return description;
}

}  // namespace csgsim::app
