#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sim/app/completion_text.h"
#include "sim/app/description.h"

namespace csgsim::app {

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

std::string word(std::string_view text) {
  std::string doubled;
  for (const char letter : text) doubled += letter == '\\' ? "\\\\" : std::string(1, letter);
  return quoted(doubled, "\\'");
}

/// `-r`: a value has to follow; `-x`: and it is no file; `-F`: it is one.
std::string value_of(const DescribedOption& option) {
  const std::string words = option.words.empty() ? "" : " -a " + word(fmt::format("{}", fmt::join(option.words, " ")));
  switch (option.kind) {
    case ValueKind::none: return "";
    case ValueKind::file:
    case ValueKind::machines: return " -r -F" + words;
    case ValueKind::words:
    case ValueKind::text: break;
  }
  return " -x" + words;
}

std::string option_line(const DescribedOption& option, const std::string& when) {
  std::string line = when;
  for (const std::string& name : option.names)
    line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  return line + value_of(option) + " -d " + word(option.meaning) + "\n";
}

std::string operand_line(const DescribedOption& operand, const std::string& when) {
  const bool is_file = operand.kind == ValueKind::file || operand.kind == ValueKind::machines;
  std::string line = when + (is_file ? " -F" : "");
  if (!operand.words.empty()) line += " -a " + word(fmt::format("{}", fmt::join(operand.words, " ")));
  return line + "\n";
}

}  // namespace

std::string fish_completion(const Description& description) {
  std::string script = fmt::format(fmt::runtime(beginning), description.program);
  const std::string begins = fmt::format("complete -c {0} -n __{0}_begins", description.program);
  for (const DescribedOption& option : description.options) script += option_line(option, begins);
  for (const DescribedCommand& command : description.commands) {
    script += begins + " -a " + command.name + " -d " + word(command.meaning) + "\n";
    const std::string when = fmt::format("complete -c {0} -n '__{0}_does {1}'", description.program, command.name);
    for (const DescribedOption& option : command.options) script += option_line(option, when);
    for (const DescribedOption& operand : command.operands) script += operand_line(operand, when);
  }
  return script;
}

}  // namespace csgsim::app
