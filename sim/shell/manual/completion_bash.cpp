#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sim/shell/manual/completion_text.h"
#include "sim/shell/manual/description.h"

namespace csgsim::shell {

namespace {

/// {0}: the program's name, {1}: words in the first place, {2}: a case of each command.
constexpr const char* bash_script = R"bash(# Completion of {0} for bash, as `{0} --describe` writes it.
_{0}() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - 1]}}
  local options="" words="" files="" prefix=""
  COMPREPLY=()
  # --option=value comes as three words.
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

/// What may stand in the value's place.
std::string value_of(const std::vector<std::string>& words, bool files) {
  std::string text;
  if (!words.empty()) text += fmt::format(" words=\"{}\"", listed(words));
  if (files) text += " files=yes";
  return text;
}

/// What may stand in the places of the operands.
std::string bash_operands_of(const CommandHelp& command) {
  std::vector<std::string> words;
  bool files = false;
  for (const OptionHelp& operand : command.operands) {
    const std::vector<std::string> some = offered_words(operand);
    words.insert(words.end(), some.begin(), some.end());
    files = files || offers_files(operand);
  }
  return value_of(words, files);
}

std::string case_of(const CommandHelp& command) {
  std::string values;
  for (const OptionHelp& option : command.options) {
    if (kind_of(option) == ValueKind::none) continue;
    const std::string value = value_of(offered_words(option), offers_files(option));
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

}  // namespace csgsim::shell
