#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sim/app/description.h"

namespace csgsim::app {

namespace {

/// {0}: the program's name, {1}: words in the first place, {2}: a case of each command.
constexpr const char* script = R"bash(# Completion of {0} for bash, as `{0} --describe` writes it.
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
  if [[ -n $files ]]; then
    local found
    mapfile -t found < <(compgen -P "$prefix" -f -- "$current")
    COMPREPLY+=("${{found[@]}}")
    compopt -o filenames 2>/dev/null
  fi
}}
complete -F _{0} {0}
)bash";

std::vector<std::string> names_of(const std::vector<DescribedOption>& options) {
  std::vector<std::string> names;
  for (const DescribedOption& option : options) names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

/// What may stand in the value's place.
std::string value_of(const DescribedOption& option) {
  std::string text;
  if (!option.words.empty()) text += fmt::format(" words=\"{}\"", fmt::join(option.words, " "));
  if (option.kind == ValueKind::file || option.kind == ValueKind::machines) text += " files=yes";
  return text;
}

std::string case_of(const DescribedCommand& command) {
  std::string values;
  for (const DescribedOption& option : command.options) {
    if (option.kind == ValueKind::none) continue;
    const std::string value = value_of(option);
    values += fmt::format("        {}){} ;;\n", fmt::join(option.names, " | "), value.empty() ? " return" : value);
  }
  std::string otherwise = fmt::format(" options=\"{}\"", fmt::join(names_of(command.options), " "));
  if (!command.operands.empty()) otherwise += value_of(command.operands.back());
  return fmt::format("    {})\n      case $previous in\n{}        *){} ;;\n      esac\n      ;;\n", command.name,
                     values, otherwise);
}

}  // namespace

std::string bash_completion(const Description& description) {
  std::vector<std::string> first = names_of(description.options);
  std::string cases;
  for (const DescribedCommand& command : description.commands) {
    first.push_back(command.name);
    cases += case_of(command);
  }
  return fmt::format(fmt::runtime(script), description.program, fmt::join(first, " "), cases);
}

}  // namespace csgsim::app
