#include "sim/shell/mistakes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "hw/base/text.h"
#include "sim/session/model/subject.h"
#include "sim/session/options/option_table.h"
#include "sim/session/options/paths.h"
#include "sim/session/options/suggestions.h"
#include "sim/shell/settings/settings_file.h"

namespace csgsim::shell {

namespace {

using session::Option;
using session::OptionList;
using session::Takes;
using Words = std::span<const std::string>;

/// A word that names no command, and what to write instead of it.
struct Replacement {
  std::string_view word;
  std::string_view instead;
};

/// Words that users try as commands, including commands of earlier versions.
constexpr auto replacements = std::to_array<Replacement>({
    {"isa", "csgsim manual instructions"},
    {"instructions", "csgsim manual instructions"},
    {"machines", "csgsim manual machines"},
    {"machine", "csgsim manual machines"},
    {"scene", "csgsim manual scenes"},
    {"scenes", "csgsim manual scenes"},
    {"methods", "csgsim manual methods"},
    {"processors", "csgsim manual processors"},
    {"processes", "csgsim manual processes"},
    {"man", "csgsim manual"},
    {"bench", "csgsim_bench"},
    {"draw", "csgsim render"},
    {"simulate", "csgsim render, or csgsim run for a Program"},
    {"export", "csgsim convert"},
    {"stl", "csgsim convert"},
    {"show", "csgsim view"},
    {"gui", "csgsim view"},
    {"disassemble", "csgsim disasm"},
    {"verilog", "csgsim rtl"},
    {"version", "csgsim --version"},
    {"-v", "csgsim --version"},
    {"-V", "csgsim --version"},
    {"-?", "csgsim --help"},
});

std::string_view replacement_of(std::string_view word) {
  const auto found = std::ranges::find(replacements, word, &Replacement::word);
  return found == replacements.end() ? std::string_view() : found->instead;
}

/// The arguments after the program's name with the command first.
std::vector<std::string> with_command_first(const std::string& command, Words arguments) {
  std::vector<std::string> words{command};
  for (const std::string& argument : arguments.subspan(1)) {
    if (argument != command) words.push_back(argument);
  }
  return words;
}

/// Advice for a file or folder typed in place of a command: the command that accepts it; empty if the word names
/// neither.
std::string command_for_file(Words arguments) {
  const std::string& file = arguments[1];
  const std::string shown = printable(file);
  const auto line = [&](const std::string& command) {
    return session::shell_command(with_command_first(command, arguments));
  };
  if (session::has_model_name(file)) return fmt::format("{} is a model; to draw it: {}", shown, line("render"));
  if (session::has_extension(file, ".csgt")) return fmt::format("{} is a Program; to run it: {}", shown, line("run"));
  if (session::has_extension(file, ".json"))
    return fmt::format("{} is no command; to repeat the run of a stats file: {}", shown, line("rerun"));
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored))
    return fmt::format("{} is a folder; to draw the models in it: {} -o FOLDER", shown, line("corpus"));
  return {};
}

/// Message for options before the command.
std::string leading_option_message(Words arguments, Words commands) {
  const std::string& first = arguments[1];
  const auto precedes = [&](const std::string& command) {
    return fmt::format("{} precedes the command; write {}", printable(first),
                       session::shell_command(with_command_first(command, arguments)));
  };
  const Words others = arguments.subspan(2);
  const auto command = std::ranges::find_first_of(others, commands);
  if (command != others.end()) return precedes(*command);
  if (std::ranges::any_of(others, [](const std::string& word) { return session::has_model_name(word); }))
    return precedes("render");
  const std::size_t equals = std::min(first.find('='), first.size());
  const std::string_view name = std::string_view(first).substr(std::min(first.find_first_not_of('-'), equals), equals);
  if (session::is_option_name(name.substr(0, name.find('='))))
    return fmt::format("{0} precedes the command; name the command first, as in csgsim render {0}", printable(first));
  const std::vector<std::string> known{"--help", "--version"};
  return fmt::format("there is no option {};{}", printable(first), session::did_you_mean(first, known));
}

/// Names of the command's options, including those of every command.
std::vector<std::string> option_names(const OptionList& command) {
  std::vector<std::string> names{"-h", "--help", std::string(config_name), std::string(dump_name)};
  for (const Option& option : command.all()) {
    if (!option.is_operand) names.insert(names.end(), option.names.begin(), option.names.end());
  }
  return names;
}

std::string name_in(const std::string& word) { return word.substr(0, word.find('=')); }

bool is_one_of(const std::string& word, Words names) { return std::ranges::find(names, word) != names.end(); }

const Option* option_named(const OptionList& command, const std::string& name) {
  const auto found = std::ranges::find_if(
      command.all(), [&](const Option& option) { return !option.is_operand && is_one_of(name, option.names); });
  return found == command.all().end() ? nullptr : &*found;
}

/// Whether the next word is the value of this one.
bool takes_next(const OptionList& command, const std::string& word) {
  if (word == config_name) return true;
  const Option* const option = option_named(command, word);
  return option != nullptr && option->takes != Takes::flag;
}

/// Whether the word is an option, as in `-o`, and not an operand, as in `-`.
bool is_like_option(const std::string& word) { return word.size() > 1 && word.starts_with('-'); }

/// Whether the word is a known short option with its value or with further short options, as in `-ofile.png`.
bool is_short_with_more(const std::string& word, Words names) {
  return !word.starts_with("--") && word.size() > 2 && is_one_of(word.substr(0, 2), names);
}

/// A surplus operand, with the two words before it.
struct Extra {
  const std::string& word;
  std::string before;         ///< the word before it; empty if there is none
  std::string before_before;  ///< the word before that one
};

/// The words that the user probably meant by a surplus operand; empty if unknown.
std::string probable_words(const Extra& extra, const OptionList& command, Words words) {
  const std::vector<std::string> names = option_names(command);
  std::string option = "--" + extra.word;
  if (is_one_of(name_in(option), names)) return option;
  const Option* const before = option_named(command, extra.before);
  const bool is_truth = extra.word == "true" || extra.word == "false";
  if (before != nullptr && before->takes == Takes::flag && is_truth) return extra.before + "=" + extra.word;
  const Option* const list = option_named(command, extra.before_before);
  const bool is_setting = list != nullptr && session::known_option(list->key()).value.starts_with("KEY=");
  if (is_setting && extra.before.find('=') == extra.before.npos)
    return fmt::format("{} {}={}", extra.before_before, extra.before, extra.word);
  const bool has_output = is_one_of("-o", words) || is_one_of("--output", words);
  const bool is_picture = session::has_extension(extra.word, ".png") || session::has_extension(extra.word, ".tif") ||
                          session::has_extension(extra.word, ".ppm") || session::has_extension(extra.word, ".gif");
  if (is_picture && !has_output && is_one_of("-o", names)) return "-o " + extra.word;
  return {};
}

/// The operands that the command takes, as in `MODEL`.
std::string operands_of(const OptionList& command) {
  std::vector<std::string> operands;
  for (const Option& option : command.all()) {
    if (option.is_operand) operands.push_back(option.shown_name());
  }
  return operands.empty() ? "no operands" : fmt::format("only {}", fmt::join(operands, " and "));
}

std::string unexpected_argument_message(const Extra& extra, const OptionList& command, Words words) {
  const std::string meant = probable_words(extra, command, words);
  const std::string shown = printable(extra.word);
  if (!meant.empty()) return fmt::format("unexpected argument '{}'; did you mean {}?", shown, printable(meant));
  return fmt::format("unexpected argument '{}'; csgsim {} takes {}", shown, command.name(), operands_of(command));
}

/// Number of operands that the command takes; no limit if it takes several of one kind.
std::optional<std::size_t> max_operands(const OptionList& command) {
  std::size_t count = 0;
  for (const Option& option : command.all()) {
    if (!option.is_operand) continue;
    if (option.takes == Takes::texts) return std::nullopt;
    ++count;
  }
  return count;
}

}  // namespace

std::string unknown_command_message(Words arguments, Words commands) {
  if (arguments.size() < 2) return "name a command, as in csgsim render MODEL -o picture.png; see csgsim --help";
  const std::string& first = arguments[1];
  if (first.empty()) return "the name of the command is empty; see csgsim --help";
  const std::string_view instead = replacement_of(first);
  const std::string shown =
      first.starts_with('-') ? "option " + printable(first) : fmt::format("command '{}'", printable(first));
  if (!instead.empty()) return fmt::format("there is no {}; did you mean {}? see csgsim --help", shown, instead);
  if (first.starts_with('-')) return with_help_hint(leading_option_message(arguments, commands), "");
  if (std::string message = command_for_file(arguments); !message.empty()) return message;
  return with_help_hint(fmt::format("there is no {};{}", shown, session::did_you_mean(first, commands)), "");
}

std::string missing_value_message(const OptionList& command, Words words) {
  const std::vector<std::string> names = option_names(command);
  for (std::size_t i = 0; i < words.size() && words[i] != "--"; ++i) {
    const bool ends_in_equals = words[i].find('=') == words[i].size() - 1;
    if (ends_in_equals && is_one_of(name_in(words[i]), names))
      return fmt::format("{}: needs a value after the '='", name_in(words[i]));
    if (!takes_next(command, words[i])) continue;
    const Option* const option = option_named(command, words[i]);
    const std::string shown = option == nullptr ? words[i] : option->shown_name();
    if (i + 1 == words.size()) return fmt::format("{}: needs a value", shown);
    const std::string& next = words[++i];
    if (is_one_of(name_in(next), names))
      return fmt::format("{0}: needs a value, but the option {1} follows; write {0}={1} if that is the value", shown,
                         printable(next));
  }
  return {};
}

std::string unreadable_word_message(const OptionList& command, Words words) {
  const std::vector<std::string> names = option_names(command);
  const std::optional<std::size_t> most = max_operands(command);
  std::size_t operands = 0;
  bool are_operands = false;  // true for every word after `--`
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (!are_operands && word == "--") {
      are_operands = true;
    } else if (!are_operands && is_like_option(word)) {
      const std::string name = name_in(word);
      if (!is_one_of(name, names) && !is_short_with_more(word, names))
        return session::unknown_option_message(printable(name), names, command.name());
      if (takes_next(command, word)) ++i;
    } else if (most && ++operands > *most) {
      return unexpected_argument_message({word, i > 0 ? words[i - 1] : "", i > 1 ? words[i - 2] : ""}, command, words);
    }
  }
  return {};
}

std::string with_help_hint(const std::string& message, std::string_view command) {
  if (message.ends_with("--help")) return message;
  const std::string_view link = message.ends_with('?') || message.ends_with(';') ? "" : ";";
  return fmt::format("{}{} see csgsim {}{}--help", message, link, command, command.empty() ? "" : " ");
}

}  // namespace csgsim::shell
