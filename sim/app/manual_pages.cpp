#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sstream>

#include "sim/app/description.h"

namespace csgsim::app {

namespace {

/// As roff prints it: no character is a command.
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

/// A text, a paragraph for each that an empty line parts; no line of it is empty.
std::string paragraphs(const std::string& text) {
  std::string page;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) page += line.empty() ? ".PP\n" : roff(line) + "\n";
  return page;
}

std::string heading(const Description& of, const std::string& name, const std::string& meaning) {
  std::string title = name;
  for (char& letter : title) letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  return fmt::format(".TH {} 1 {} \"{} {}\"\n.SH NAME\n{} \\- {}\n", roff(title), of.date, of.program, of.version,
                     roff(name), roff(meaning));
}

/// What stands for the option's value.
std::string value_name(const DescribedOption& option) {
  switch (option.kind) {
    case ValueKind::none: return "";
    case ValueKind::words: return "WORD";
    case ValueKind::file: return "FILE";
    case ValueKind::machines: return "MACHINE";
    case ValueKind::text: break;
  }
  return option.type == "TEXT" ? "TEXT" : "NUMBER";
}

std::string tag(const DescribedOption& option) {
  if (option.names.empty()) return fmt::format("\\fI{}\\fR{}", roff(option.name), option.takes_several ? " ..." : "");
  std::vector<std::string> names;
  names.reserve(option.names.size());
  for (const std::string& name : option.names) names.push_back("\\fB" + roff(name) + "\\fR");
  std::string all = fmt::format("{}", fmt::join(names, ", "));
  if (option.kind != ValueKind::none) all += " \\fI" + value_name(option) + "\\fR";
  if (option.takes_several) all += " ...";
  return all;
}

std::string entry(const DescribedOption& option) {
  std::string text = option.meaning;
  if (!option.words.empty()) {
    text += fmt::format("\n{}: {}.", option.kind == ValueKind::machines ? "Built in" : "One of",
                        fmt::join(option.words, ", "));
  }
  if (!option.range.empty()) text += "\nRange: " + option.range + ".";
  if (!option.usual.empty()) text += "\nDefault: " + option.usual + ".";
  return ".TP\n" + tag(option) + "\n" + paragraphs(text);
}

std::string section(const std::string& name, const std::vector<DescribedOption>& options) {
  if (options.empty()) return {};
  std::string text = ".SH " + name + "\n";
  for (const DescribedOption& option : options) text += entry(option);
  return text;
}

/// The footer's first line is the heading: `Example:`.
std::string examples(const std::string& footer) {
  const std::size_t end = footer.find('\n');
  if (end == std::string::npos) return {};
  return ".SH EXAMPLES\n.nf\n" + roff(footer.substr(end + 1)) + "\n.fi\n";
}

std::string ends(const Description& of) {
  return ".SH EXIT STATUS\n.TP\n0\nAll went well.\n.TP\n1\nAn input is bad, or an output cannot be written; "
         "the message says where and why.\n.TP\n2\nThe command line makes no sense.\n.TP\n3\nA fault of " +
         of.program + " itself.\n";
}

std::string synopsis_of(const Description& of, const DescribedCommand& command) {
  std::string text = fmt::format(".SH SYNOPSIS\n\\fB{} {}\\fR [\\fIOPTIONS\\fR]", roff(of.program), roff(command.name));
  for (const DescribedOption& operand : command.operands) {
    const std::string name = fmt::format("\\fI{}\\fR{}", roff(operand.name), operand.takes_several ? " ..." : "");
    text += operand.is_required ? " " + name : " [" + name + "]";
  }
  return text + "\n";
}

DescriptionFile page_of(const Description& of, const DescribedCommand& command) {
  const std::string name = of.program + "-" + command.name;
  const std::string text = heading(of, name, command.meaning) + synopsis_of(of, command) + ".SH DESCRIPTION\n" +
                           paragraphs(command.meaning + ".") + section("OPERANDS", command.operands) +
                           section("OPTIONS", command.options) + examples(command.footer) + ends(of) +
                           fmt::format(".SH SEE ALSO\n.BR {} (1)\n", roff(of.program));
  return {name + ".1", text};
}

/// The description begins with the program's name, which the heading has already.
std::string meaning_of(const Description& of) {
  const std::string begin = of.program + ": ";
  return of.meaning.starts_with(begin) ? of.meaning.substr(begin.size()) : of.meaning;
}

DescriptionFile page_of_all(const Description& of) {
  std::string text = heading(of, of.program, meaning_of(of)) +
                     fmt::format(".SH SYNOPSIS\n\\fB{0}\\fR \\fICOMMAND\\fR [\\fIOPTIONS\\fR] [\\fIOPERANDS\\fR]\n",
                                 roff(of.program)) +
                     ".SH DESCRIPTION\n" + paragraphs(meaning_of(of) + ".") +
                     ".SH COMMANDS\nEach has a page of its own.\n";
  std::string pages;
  for (const DescribedCommand& command : of.commands) {
    const std::string page = roff(of.program + "-" + command.name);
    text += fmt::format(".TP\n.BR {} (1)\n{}", page, paragraphs(command.meaning + "."));
    pages += fmt::format("{}.BR {} (1)", pages.empty() ? "" : " ,\n", page);
  }
  text += section("OPTIONS", of.options) + ends(of);
  return {of.program + ".1", text + ".SH SEE ALSO\n" + pages + "\n"};
}

}  // namespace

std::vector<DescriptionFile> manual_pages(const Description& description) {
  std::vector<DescriptionFile> pages{page_of_all(description)};
  for (const DescribedCommand& command : description.commands) pages.push_back(page_of(description, command));
  return pages;
}

}  // namespace csgsim::app
