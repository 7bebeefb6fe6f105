#include <fmt/format.h>

#include "sim/shell/manual/completion_text.h"
#include "sim/shell/manual/description.h"

namespace csgsim::shell {

namespace {

/// {0}: the program's name.
constexpr const char* beginning = R"fish(# Completion of {0} for fish, as `{0} --describe` writes it.
function __{0}_does
    set -l words (commandline -opc)
    test (count $words) -gt 1; and test $words[2] = $argv[1]
end
function __{0}_begins
    test (count (commandline -opc)) -eq 1
end
complete -c {0} -f
)fish";

std::string fish_word(std::string_view text) {
  std::string doubled;
  for (const char letter : text) doubled += letter == '\\' ? "\\\\" : std::string(1, letter);
  return quoted(doubled, "\\'");
}

std::string words_of(const OptionHelp& option) {
  const std::vector<std::string> words = offered_words(option);
  return words.empty() ? "" : " -a " + fish_word(listed(words));
}

/// `-r`: a value has to follow; `-x`: and it is no file; `-F`: it is one.
std::string value_of(const OptionHelp& option) {
  if (kind_of(option) == ValueKind::none) return "";
  return (offers_files(option) ? " -r -F" : " -x") + words_of(option);
}

std::string option_line(const OptionHelp& option, const std::string& when) {
  std::string line = when;
  for (const std::string& name : option.names)
    line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  return line + value_of(option) + " -d " + fish_word(option.meaning) + "\n";
}

std::string operand_line(const OptionHelp& operand, const std::string& when) {
  return when + (offers_files(operand) ? " -F" : "") + words_of(operand) + "\n";
}

}  // namespace

std::string fish_completion(const Description& description) {
  std::string script = fmt::format(fmt::runtime(beginning), description.program);
  const std::string begins = fmt::format("complete -c {0} -n __{0}_begins", description.program);
  for (const OptionHelp& option : description.options) script += option_line(option, begins);
  for (const CommandHelp& command : description.commands) {
    script += begins + " -a " + command.name + " -d " + fish_word(command.meaning) + "\n";
    const std::string when = fmt::format("complete -c {0} -n '__{0}_does {1}'", description.program, command.name);
    for (const OptionHelp& option : command.options) script += option_line(option, when);
    for (const OptionHelp& operand : command.operands) script += operand_line(operand, when);
  }
  return script;
}

}  // namespace csgsim::shell
