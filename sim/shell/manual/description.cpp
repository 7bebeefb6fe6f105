#include "sim/shell/manual/description.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <utility>

#include "hw/base/output_file.h"
#include "hw/kinds/load.h"
#include "hw/processors/processor.h"
#include "sim/session/options/option_table.h"
#include "sim/session/options/version.h"

namespace csgsim::shell {

namespace {

/// The option's name as in option_table.h: the first long name, or an operand's name in lower case.
std::string settings_name(const OptionHelp& option) {
  std::string name = long_name(option);
  if (name.empty()) name = option.names.front();
  std::ranges::transform(name, name.begin(), [](unsigned char letter) { return std::tolower(letter); });
  return name;
}

const char* type_of(const Option& option) {
  if (option.is_folder) return folder_type;
  switch (option.takes) {
    case Takes::flag: return "";
    case Takes::whole_number: return "UINT";
    case Takes::number: return "FLOAT";
    case Takes::text:
    case Takes::texts: break;
  }
  return "TEXT";
}

OptionHelp make_option_help(const Option& option) {
  return {.names = option.names,
          .type = type_of(option),
          .meaning = option.meaning,
          .words = option.offered,
          .range = option.range,
          .usual = option.is_required ? std::string() : option.usual,
          .is_needed = option.is_required,
          .takes_several = option.takes == Takes::texts};
}

OptionHelp make_own_help(std::vector<std::string> names, std::string type, std::string meaning) {
  OptionHelp help;
  help.names = std::move(names);
  help.type = std::move(type);
  help.meaning = std::move(meaning);
  return help;
}

OptionHelp make_help_option() { return make_own_help({"-h", "--help"}, "", "Print this help message and exit"); }

}  // namespace

CommandHelp make_help(const Command& command) {
  CommandHelp help{command.name(), command.subject, command.description, command.footer, {}, {make_help_option()}};
  for (const Option& option : command.all())
    (option.is_operand ? help.operands : help.options).push_back(make_option_help(option));
  if (command.all().empty()) return help;
  help.options.push_back(make_own_help(
      {std::string(config_name)}, "TEXT",
      "A settings file, .toml, with options of this command and others; the command line takes precedence"));
  help.options.push_back(make_own_help({std::string(dump_name)}, "",
                                       "Print all options with their current values as a settings file, and exit"));
  return help;
}

std::vector<CommandHelp> make_command_helps(const std::deque<Command>& commands) {
  std::vector<CommandHelp> helps;
  for (const Command& command : commands) helps.push_back(make_help(command));
  return helps;
}

Description describe(const std::string& program, const std::string& meaning, const std::deque<Command>& commands) {
  return {program,
          meaning,
          version(),
          source_date(),
          {make_help_option(), make_own_help({"--version"}, "", "Print version, commit, build and libraries")},
          make_command_helps(commands)};
}

ValueKind value_kind(const OptionHelp& option) {
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

std::vector<std::string> completion_words(const OptionHelp& option) {
  const ValueKind kind = value_kind(option);
  if (kind != ValueKind::machines && kind != ValueKind::processors) return option.words;
  const std::vector<std::string_view> names =
      kind == ValueKind::machines ? kinds::built_in_names() : processors::processor_names();
  std::vector<std::string> words(names.begin(), names.end());
  if (kind == ValueKind::processors) words.emplace_back(processors::this_computer);
  return words;
}

bool offers_files(const OptionHelp& option) {
  const ValueKind kind = value_kind(option);
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
