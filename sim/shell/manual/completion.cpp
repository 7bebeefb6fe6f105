#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <string_view>
#include <vector>

#include "hw/kinds/load.h"
#include "sim/shell/manual/description.h"

namespace csgsim::shell {

namespace {

/// One word in single quotes. `inside` replaces each single quote in it: '\'' in sh, \' in fish.
std::string quoted(std::string_view text, std::string_view inside) {
  std::string word = "'";
  for (const char letter : text) {
    if (letter == '\'') {
      word += inside;
    } else {
      word += letter == '\n' ? ' ' : letter;
    }
  }
  return word + "'";
}

/// Words separated by blanks; a blank inside a word is escaped by a backslash, which all shells understand.
std::string word_list(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) {
    if (!list.empty()) list += ' ';
    for (const char letter : word) list += letter == ' ' ? "\\ " : std::string(1, letter);
  }
  return list;
}

/// {0}: the program's name, {1}: words in the first position, {2}: a case for each command.
constexpr const char* bash_script = R"bash(# Completion of {0} for bash, written by `{0} --describe`.
_{0}() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - 1]}}
  local options="" words="" files="" prefix=""
  COMPREPLY=()
  # Bash splits --option=value into three words.
  if [[ $current == = ]]; then
    current=""
  elif [[ $previous == = ]]; then
    previous=${{COMP_WORDS[COMP_CWORD - 2]}}
  fi
  if ((COMP_CWORD == 1)); then
    mapfile -t COMPREPLY < <(compgen -W "{1}" -- "$current")
    return
  fi
  case ${{COMP_WORDS[1]}} in
{2}    *)
      return
      ;;
  esac
  if [[ $current == -* && -n $options ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$current")
    return
  fi
  if [[ -n $words && $current == *,* ]]; then
    prefix=${{current%,*}},
    current=${{current##*,}}
  fi
  if [[ -n $words ]]; then mapfile -t COMPREPLY < <(compgen -P "$prefix" -W "$words" -- "$current"); fi
  if [[ $words == *\\* ]]; then compopt -o filenames 2>/dev/null; fi
  if [[ -n $files ]]; then
    local found
    mapfile -t found < <(compgen -P "$prefix" -f -- "$current")
    COMPREPLY+=("${{found[@]}}")
    compopt -o filenames 2>/dev/null
  fi
}}
complete -F _{0} {0}
)bash";

std::vector<std::string> names_of(const std::vector<OptionHelp>& options) {
  std::vector<std::string> names;
  for (const OptionHelp& option : options) names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

/// The completions of a value, as shell variables.
std::string value_of(const std::vector<std::string>& words, bool files) {
  std::string text;
  if (!words.empty()) text += fmt::format(" words=\"{}\"", word_list(words));
  if (files) text += " files=yes";
  return text;
}

/// Lines of the bash script that complete the operands of a command.
std::string bash_operands_of(const CommandHelp& command) {
  std::vector<std::string> words;
  bool files = false;
  for (const OptionHelp& operand : command.operands) {
    const std::vector<std::string> some = completion_words(operand);
    words.insert(words.end(), some.begin(), some.end());
    files = files || offers_files(operand);
  }
  return value_of(words, files);
}

std::string case_of(const CommandHelp& command) {
  std::string values;
  for (const OptionHelp& option : command.options) {
    if (value_kind(option) == ValueKind::none) continue;
    const std::string value = value_of(completion_words(option), offers_files(option));
    values += fmt::format("        {}){} ;;\n", fmt::join(option.names, " | "), value.empty() ? " return" : value);
  }
  const std::string otherwise =
      fmt::format(" options=\"{}\"", fmt::join(names_of(command.options), " ")) + bash_operands_of(command);
  return fmt::format("    {})\n      case $previous in\n{}        *){} ;;\n      esac\n      ;;\n", command.name,
                     values, otherwise);
}

}  // namespace

std::string bash_completion(const Description& description) {
  std::vector<std::string> first = names_of(description.options);
  std::string cases;
  for (const CommandHelp& command : description.commands) {
    first.push_back(command.name);
    cases += case_of(command);
  }
  return fmt::format(fmt::runtime(bash_script), description.program, fmt::join(first, " "), cases);
}

namespace {

/// {0}: the program's name, {1}: the machines, {2}: commands, {3}: options in the first position, {4}: a case for each
/// command.
constexpr const char* zsh_script = R"zsh(#compdef {0}
# Completion of {0} for zsh, written by `{0} --describe`.
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

/// Escapes brackets, colons and backslashes.
std::string literal(std::string_view text) {
  std::string escaped;
  for (const char letter : text) {
    if (std::string_view("[]:\\").find(letter) != std::string_view::npos) escaped += '\\';
    escaped += letter;
  }
  return escaped;
}

std::string zsh_word(std::string_view text) { return quoted(text, "'\\''"); }

/// The zsh action that completes the value.
std::string action_of(const OptionHelp& option, const std::string& program) {
  switch (value_kind(option)) {
    case ValueKind::words:
      return fmt::format(fmt::runtime(option.takes_several ? "_sequence compadd - {}" : "({})"),
                         word_list(option.words));
    case ValueKind::file: return "_files";
    case ValueKind::machines: return "_" + program + "_machines";
    case ValueKind::processors:
      return fmt::format("{{_alternative \"processors:processor:({})\" \"files:file:_files\"}}",
                         word_list(completion_words(option)));
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
    if (value_kind(option) != ValueKind::none) spec += name.starts_with("--") ? "=" : "+";
    spec += "[" + literal(option.meaning) + "]";
    if (value_kind(option) != ValueKind::none)
      spec += ":" + literal(value_placeholder(option)) + ":" + action_of(option, program);
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

namespace {

/// {0}: the program's name.
constexpr const char* fish_beginning = R"fish(# Completion of {0} for fish, written by `{0} --describe`.
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
  const std::vector<std::string> words = completion_words(option);
  return words.empty() ? "" : " -a " + fish_word(word_list(words));
}

/// `-r`: a value has to follow; `-x`: a value that is no file; `-F`: a file.
std::string value_of(const OptionHelp& option) {
  if (value_kind(option) == ValueKind::none) return "";
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
  std::string script = fmt::format(fmt::runtime(fish_beginning), description.program);
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
