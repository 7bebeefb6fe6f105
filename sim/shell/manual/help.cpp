#include "sim/shell/manual/help.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

#include "sim/session/options/option_table.h"

namespace csgsim::shell {

namespace {

constexpr std::size_t indent = 2;
constexpr std::size_t text_column = 26;
constexpr std::string_view continued = " \\";

/// Wraps a text that starts at `column`; further lines start at `next_column`. Each line but the last ends with `mark`.
/// A word longer than a line stays whole.
std::string wrapped(std::string_view text, std::size_t column, std::size_t next_column, std::string_view mark = {},
                    std::size_t columns = help_columns) {
  std::string lines;
  std::size_t at = column;
  bool is_first = true;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::size_t needed = at + (is_first ? 0 : 1) + word.size() + (text.empty() ? 0 : mark.size());
    if (!is_first && needed > columns) {
      lines += fmt::format("{}\n{}{}", mark, std::string(next_column, ' '), word);
      at = next_column + word.size();
    } else {
      lines += (is_first ? "" : " ") + std::string(word);
      at += (is_first ? 0 : 1) + word.size();
    }
    is_first = false;
  }
  return lines;
}

/// Adds a blank after each comma of a long list, so that the list can be wrapped.
std::string with_breakable_commas(std::string list) {
  constexpr std::size_t longest = help_columns - text_column;
  if (list.size() < longest / 2) return list;
  for (std::size_t at = list.find(','); at != std::string::npos; at = list.find(',', at + 2)) list.insert(at + 1, " ");
  return list;
}

std::string meaning_of(const OptionHelp& option) {
  std::string text = option.meaning;
  if (!option.words.empty()) text += fmt::format(". Values: {}", fmt::join(option.words, ", "));
  std::string remarks;
  const auto remark = [&](const std::string& one) { remarks += (remarks.empty() ? "" : "; ") + one; };
  if (!option.range.empty()) remark(option.range);
  if (!option.usual.empty()) remark("default: " + with_breakable_commas(option.usual));
  if (option.is_needed) remark("required");
  return remarks.empty() ? text : text + " [" + remarks + "]";
}

std::string line_of(const std::string& names, const std::string& meaning) {
  std::string line = std::string(indent, ' ') + names;
  if (line.size() + 2 > text_column) {
    line += '\n';
    line.append(text_column, ' ');
  } else {
    line.resize(text_column, ' ');
  }
  return line + wrapped(meaning, text_column, text_column) + "\n";
}

std::string operand_lines(const CommandHelp& command) {
  std::string text;
  for (const OptionHelp& operand : command.operands)
    text += line_of(operand.names.front() + (operand.takes_several ? " ..." : ""), meaning_of(operand));
  return text;
}

std::string option_lines(const CommandHelp& command) {
  std::string text;
  for (const auto& [subject, options] : group_by_subject(command.options)) {
    text += fmt::format("\n{}:\n", subject);
    for (const OptionHelp* const option : options) {
      const std::string value = value_placeholder(*option);
      text += line_of(fmt::format("{}{}{}", fmt::join(option->names, ", "), value.empty() ? "" : " ", value),
                      meaning_of(*option));
    }
  }
  return text;
}

/// Placeholder for a blank at which no line may break.
constexpr char joint = '\x01';

/// Keeps each option of an example on the same line as its value.
std::string with_joined_values(std::string_view line) {
  std::string text(line);
  for (std::size_t at = text.find(" -"); at != std::string::npos; at = text.find(" -", at + 1)) {
    const std::size_t blank = text.find(' ', at + 1);
    if (blank != std::string::npos && text[blank + 1] != '-') text[blank] = joint;
  }
  return text;
}

bool is_command(std::string_view line) { return line.starts_with("  "); }

/// Whether the rest of a footer continues the preceding remark.
bool continues_remark(std::string_view footer) {
  return !footer.empty() && !is_command(footer) && !footer.starts_with('\n') && !footer.starts_with("Example:");
}

std::string_view taken_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

std::string usage_line(const CommandHelp& command) {
  std::string line = fmt::format("Usage: csgsim {} [OPTIONS]", command.name);
  for (const OptionHelp& operand : command.operands) {
    const std::string name = operand.names.front() + (operand.takes_several ? "..." : "");
    line += operand.is_needed ? " " + name : " [" + name + "]";
  }
  return wrapped(line, 0, indent) + "\n";
}

}  // namespace

std::string long_name(const OptionHelp& option) {
  const auto found = std::ranges::find_if(option.names, [](const std::string& name) { return name.starts_with("--"); });
  return found == option.names.end() ? std::string() : found->substr(2);
}

std::string value_placeholder(const OptionHelp& option) {
  if (option.type.empty() || option.type == folder_type) return option.type;
  const std::string_view value = session::known_option(long_name(option)).value;
  if (!value.empty()) return std::string(value);
  if (!option.words.empty()) return "WORD";
  return option.type == "UINT" ? "N" : option.type == "FLOAT" ? "X" : "TEXT";
}

std::vector<SubjectHelp> group_by_subject(std::span<const OptionHelp> options) {
  std::vector<SubjectHelp> subjects;
  for (const OptionHelp& option : options) {
    const std::string_view subject = session::known_option(long_name(option)).subject;
    auto found = std::ranges::find(subjects, subject, &SubjectHelp::subject);
    if (found == subjects.end()) found = subjects.insert(found, SubjectHelp{subject, {}});
    found->options.push_back(&option);
  }
  std::ranges::sort(subjects, {}, [](const SubjectHelp& one) { return session::heading_position(one.subject); });
  return subjects;
}

std::string wrap_footer(std::string_view footer, std::size_t columns) {
  std::string text;
  while (!footer.empty()) {
    const std::string_view line = taken_line(footer);
    if (is_command(line)) {
      text += "  " + wrapped(with_joined_values(line.substr(indent)), indent, indent + 4, continued, columns) + '\n';
      continue;
    }
    std::string remark(line);
    while (continues_remark(footer)) remark += fmt::format(" {}", taken_line(footer));
    text += wrapped(remark, 0, 0, {}, columns) + '\n';
  }
  std::ranges::replace(text, joint, ' ');
  return text;
}

std::string help_text(const CommandHelp& command) {
  std::string text = wrapped(command.meaning, 0, 0) + "\n" + usage_line(command);
  if (!command.operands.empty()) text += "\n" + operand_lines(command);
  text += option_lines(command);
  if (!command.footer.empty()) text += "\n" + wrap_footer(command.footer, help_columns);
  return text;
}

std::string overview_text(const std::string& meaning, std::span<const CommandHelp> commands) {
  std::string text = wrapped(meaning, 0, 0) + "\nUsage: csgsim COMMAND [OPTIONS]\n";
  std::vector<std::string_view> subjects;
  for (const CommandHelp& command : commands) {
    if (std::ranges::find(subjects, command.subject) == subjects.end()) subjects.push_back(command.subject);
  }
  for (const std::string_view subject : subjects) {
    text += fmt::format("\n{}:\n", subject);
    for (const CommandHelp& command : commands)
      if (command.subject == subject) text += line_of(command.name, command.meaning);
  }
  return text + "\n" +
         wrapped(
             "csgsim COMMAND --help lists the options of a command, with an example. csgsim --version prints the "
             "version.",
             0, 0) +
         "\n";
}

}  // namespace csgsim::shell
