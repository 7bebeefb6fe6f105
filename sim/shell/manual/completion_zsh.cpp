#include <fmt/format.h>
#include <fmt/ranges.h>

#include "hw/kinds/load.h"
#include "sim/shell/manual/completion_text.h"
#include "sim/shell/manual/description.h"

namespace csgsim::shell {

namespace {

/// {0}: the program's name, {1}: the machines, {2}: commands, {3}: options in the first place, {4}: a case of each
/// command.
constexpr const char* zsh_script = R"zsh(#compdef {0}
# Completion of {0} for zsh, as `{0} --describe` writes it.
_{0}_machines() {{
  _alternative 'machines:machine:({1})' 'files:file:_files'
}}
_{0}() {{
  local -a commands
  commands=(
{2}  )
  if ((CURRENT == 2)); then
    _describe command commands
    _arguments{3}
    return
  fi
  local command=$words[2]
  shift words
  ((CURRENT--))
  case $command in
{4}  esac
}}
if [[ $funcstack[1] == _{0} ]]; then _{0} "$@"; else compdef _{0} {0}; fi
)zsh";

/// Brackets, colons and backslashes stand for themselves.
std::string literal(std::string_view text) {
  std::string escaped;
  for (const char letter : text) {
    if (std::string_view("[]:\\").find(letter) != std::string_view::npos) escaped += '\\';
    escaped += letter;
  }
  return escaped;
}

std::string zsh_word(std::string_view text) { return quoted(text, "'\\''"); }

/// What completes the value.
std::string action_of(const OptionHelp& option, const std::string& program) {
  switch (kind_of(option)) {
    case ValueKind::words:
      return fmt::format(fmt::runtime(option.takes_several ? "_sequence compadd - {}" : "({})"), listed(option.words));
    case ValueKind::file: return "_files";
    case ValueKind::machines: return "_" + program + "_machines";
    case ValueKind::none:
    case ValueKind::text: break;
  }
  return " ";
}

std::string option_lines(const OptionHelp& option, const std::string& program) {
  const std::string others = option.takes_several ? "*" : fmt::format("({})", fmt::join(option.names, " "));
  std::string lines;
  for (const std::string& name : option.names) {
    std::string spec = others + name;
    if (kind_of(option) != ValueKind::none) spec += name.starts_with("--") ? "=" : "+";
    spec += "[" + literal(option.meaning) + "]";
    if (kind_of(option) != ValueKind::none)
      spec += ":" + literal(value_name(option)) + ":" + action_of(option, program);
    lines += " \\\n        " + zsh_word(spec);
  }
  return lines;
}

std::string case_of(const CommandHelp& command, const std::string& program) {
  std::string text = fmt::format("    {})\n      _arguments", command.name);
  for (const OptionHelp& option : command.options) text += option_lines(option, program);
  for (const OptionHelp& operand : command.operands) {
    const std::string several = operand.takes_several ? "*" : "";
    text += " \\\n        " + zsh_word(several + ":" + operand.names.front() + ":" + action_of(operand, program));
  }
  return text + "\n      ;;\n";
}

}  // namespace

std::string zsh_completion(const Description& description) {
  std::string commands;
  std::string cases;
  for (const CommandHelp& command : description.commands) {
    commands += "    " + zsh_word(command.name + ":" + literal(command.meaning)) + "\n";
    cases += case_of(command, description.program);
  }
  std::string options;
  for (const OptionHelp& option : description.options) options += option_lines(option, description.program);
  return fmt::format(fmt::runtime(zsh_script), description.program, fmt::join(kinds::built_in_names(), " "), commands,
                     options, cases);
}

}  // namespace csgsim::shell
