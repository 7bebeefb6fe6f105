#include "sim/shell/manual/description.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <utility>

#include "hw/base/output_file.h"
#include "hw/kinds/load.h"
#include "hw/processors/processor.h"
#include "sim/shell/lists.h"
#include "sim/shell/option_table.h"
#include "sim/shell/version.h"

namespace csgsim::shell {

namespace {

/// As file_options.h knows it: an operand's name is in small letters there.
std::string settings_name(const OptionHelp& option) {
  std::string name = long_name(option);
  if (name.empty()) name = option.names.front();
  std::ranges::transform(name, name.begin(), [](unsigned char letter) { return std::tolower(letter); });
  return name;
}

/// What a check of that name tells of itself; empty if there is none.
std::string told_by(CLI::Option& option, const char* check) {
  try {
    return option.get_validator(check)->get_description();
  } catch (const CLI::OptionNotFound&) {
    return {};
  }
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
  if (const std::string words = told_by(option, words_check); !words.empty()) {
    for (const std::string_view word : split(words, ", ")) help.words.emplace_back(word);
  }
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

ValueKind kind_of(const OptionHelp& option) {
  if (option.type.empty()) return ValueKind::none;
  if (!option.words.empty()) return ValueKind::words;
  switch (known_option(settings_name(option)).role) {
    case FileRole::input:
    case FileRole::output: return ValueKind::file;
    case FileRole::machines: return ValueKind::machines;
    case FileRole::processors: return ValueKind::processors;
    case FileRole::processes: return ValueKind::file;
    case FileRole::none: break;
  }
  return ValueKind::text;
}

std::vector<std::string> offered_words(const OptionHelp& option) {
  const ValueKind kind = kind_of(option);
  if (kind != ValueKind::machines && kind != ValueKind::processors) return option.words;
  const std::vector<std::string_view> names =
      kind == ValueKind::machines ? kinds::built_in_names() : processors::processor_names();
  std::vector<std::string> words(names.begin(), names.end());
  if (kind == ValueKind::processors) words.emplace_back(processors::this_computer);
  return words;
}

bool offers_files(const OptionHelp& option) {
  const ValueKind kind = kind_of(option);
  return kind == ValueKind::file || kind == ValueKind::machines || kind == ValueKind::processors;
}

void write_description(const Description& description, const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) fail_to_write(folder, error);
  std::vector<DescriptionFile> files = manual_pages(description);
  files.push_back({description.program + ".bash", bash_completion(description)});
  files.push_back({"_" + description.program, zsh_completion(description)});
  files.push_back({description.program + ".fish", fish_completion(description)});
  for (const DescriptionFile& file : files) write_file(std::filesystem::path(folder) / file.name, file.content);
}

}  // namespace csgsim::shell
