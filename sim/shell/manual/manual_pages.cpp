#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cctype>
#include <span>
#include <sstream>
#include <string_view>

#include "sim/shell/manual/description.h"

namespace csgsim::shell {

namespace {

/// Escapes a text for roff, so that no character acts as a command.
std::string roff(std::string_view text) {
  std::string escaped;
  bool begins_line = true;
  for (const char letter : text) {
    if (begins_line && (letter == '.' || letter == '\'')) escaped += "\\&";
    begins_line = letter == '\n';
    switch (letter) {
      case '\\': escaped += "\\e"; break;
      case '-': escaped += "\\-"; break;
      case '\'': escaped += "\\(aq"; break;
      case '`': escaped += "\\(ga"; break;
      case '^': escaped += "\\(ha"; break;
      case '~': escaped += "\\(ti"; break;
      default: escaped += letter;
    }
  }
  return escaped;
}

/// Converts a text to roff paragraphs, separated at empty lines; the page gets no empty line.
std::string paragraphs(const std::string& text) {
  std::string page;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) page += line.empty() ? ".PP\n" : roff(line) + "\n";
  return page;
}

std::string heading(const Description& of, const std::string& name, const std::string& meaning) {
  std::string title = name;
  for (char& letter : title) letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  // Option names are long: suppress hyphenation and wide gaps.
  return fmt::format(".TH {} 1 {} \"{} {}\"\n.nh\n.ad l\n.SH NAME\n{} \\- {}\n", roff(title), of.date, of.program,
                     of.version, roff(name), roff(meaning));
}

std::string bold(std::string_view text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + roff(text) + "\\fR"; }

std::string tag(const OptionHelp& option) {
  const std::string several = option.takes_several ? " ..." : "";
  if (!option.names.front().starts_with('-')) return italic(option.names.front()) + several;
  std::vector<std::string> names;
  names.reserve(option.names.size());
  for (const std::string& name : option.names) names.push_back(bold(name));
  const std::string value = value_placeholder(option);
  return fmt::format("{}{}{}", fmt::join(names, ", "), value.empty() ? "" : " " + italic(value), several);
}

std::string entry(const OptionHelp& option) {
  std::string text = option.meaning + ".";
  const std::vector<std::string> words = completion_words(option);
  if (!words.empty())
    text += fmt::format("\n{}: {}.", option.words.empty() ? "Built in" : "Values", fmt::join(words, ", "));
  if (!option.range.empty()) text += "\nRange: " + option.range + ".";
  if (!option.usual.empty()) text += "\nDefault: " + option.usual + ".";
  if (option.is_needed && option.names.front().starts_with('-')) text += "\nRequired.";
  return ".TP\n" + tag(option) + "\n" + paragraphs(text);
}

std::string entries(std::span<const OptionHelp> options) {
  std::string text;
  for (const OptionHelp& option : options) text += entry(option);
  return text;
}

std::string operands_of(const CommandHelp& command) {
  return command.operands.empty() ? "" : ".SH OPERANDS\n" + entries(command.operands);
}

/// Options under the headings of help.
std::string options_of(const CommandHelp& command) {
  std::string text = ".SH OPTIONS\n";
  for (const auto& [subject, options] : group_by_subject(command.options)) {
    text += ".SS " + roff(subject) + "\n";
    for (const OptionHelp* const option : options) text += entry(*option);
  }
  return text;
}

/// Width of a terminal's 80 columns less the indentation of man.
constexpr std::size_t example_columns = 70;

std::string examples(const CommandHelp& command) {
  if (command.footer.empty()) return {};
  constexpr std::string_view first_line = "Example:\n";
  std::string text = wrap_footer(command.footer, example_columns);
  if (text.starts_with(first_line)) text.erase(0, first_line.size());
  return ".SH EXAMPLES\n.nf\n" + roff(text) + ".fi\n";
}

std::string closing_sections(const Description& of) {
  return ".SH EXIT STATUS\n.TP\n0\nSuccess.\n.TP\n1\nAn input is invalid, or an output cannot be written; "
         "the message says where and why.\n.TP\n2\nThe command line is invalid.\n.TP\n3\nA bug in " +
         of.program + " itself.\n";
}

std::string synopsis_of(const Description& of, const CommandHelp& command) {
  std::string text = fmt::format(".SH SYNOPSIS\n{} [{}]", bold(of.program + " " + command.name), italic("OPTIONS"));
  for (const OptionHelp& operand : command.operands)
    text += fmt::format(fmt::runtime(operand.is_needed ? " {}" : " [{}]"), tag(operand));
  return text + "\n";
}

DescriptionFile page_of(const Description& of, const CommandHelp& command) {
  const std::string name = of.program + "-" + command.name;
  const std::string text = heading(of, name, command.meaning) + synopsis_of(of, command) + ".SH DESCRIPTION\n" +
                           paragraphs(command.meaning + ".") + operands_of(command) + options_of(command) +
                           examples(command) + closing_sections(of) +
                           fmt::format(".SH SEE ALSO\n.BR {} (1)\n", roff(of.program));
  return {name + ".1", text};
}

/// The program's meaning without the leading program name, which the heading already has.
std::string meaning_of(const Description& of) {
  const std::string begin = of.program + ": ";
  return of.meaning.starts_with(begin) ? of.meaning.substr(begin.size()) : of.meaning;
}

DescriptionFile page_of_all(const Description& of) {
  std::string text = heading(of, of.program, meaning_of(of)) +
                     fmt::format(".SH SYNOPSIS\n{} {} [{}] [{}]\n", bold(of.program), italic("COMMAND"),
                                 italic("OPTIONS"), italic("OPERANDS")) +
                     ".SH DESCRIPTION\n" + paragraphs(meaning_of(of) + ".") + ".SH COMMANDS\nEach has its own page.\n";
  std::string pages;
  for (const CommandHelp& command : of.commands) {
    const std::string page = roff(of.program + "-" + command.name);
    text += fmt::format(".TP\n.BR {} (1)\n{}", page, paragraphs(command.meaning + "."));
    pages += fmt::format("{}.BR {} (1)", pages.empty() ? "" : " ,\n", page);
  }
  text += ".SH OPTIONS\n" + entries(of.options) + closing_sections(of);
  return {of.program + ".1", text + ".SH SEE ALSO\n" + pages + "\n"};
}

}  // namespace

std::vector<DescriptionFile> manual_pages(const Description& description) {
  std::vector<DescriptionFile> pages{page_of_all(description)};
  for (const CommandHelp& command : description.commands) pages.push_back(page_of(description, command));
  return pages;
}

}  // namespace csgsim::shell
