#include "sim/python/call.h"

#include <algorithm>
#include <array>
#include <memory>
#include <string_view>

#include "hw/base/standard_streams.h"
#include "sim/calls/explain.h"
#include "sim/calls/render.h"
#include "sim/calls/run.h"
#include "sim/shell/model_options.h"
#include "sim/shell/option_table.h"
#include "sim/shell/usage.h"
#include "sim/studies/rows.h"
#include "sim/studies/runner.h"

namespace csgsim::python {

namespace {

/// What every command has that only a terminal has a use for.
constexpr auto of_terminals = std::to_array<std::string_view>({"help", "dump-config"});

void refuse_terminal_options(const Call& call) {
  for (const auto& [name, text] : call.options) {
    const bool is_of_terminals = std::ranges::find(of_terminals, name) != of_terminals.end();
    if (is_of_terminals) throw shell::UsageError("--" + name, "is for the command line alone");
    const bool is_output = shell::known_option(name).role == shell::FileRole::output;
    if (is_output && text && is_standard_output(*text))
      throw shell::UsageError("--" + name, "name a file; what the command line would print is returned");
  }
}

/// A name that begins with a dash is a file's all the same.
std::string operand_word(const std::string& operand) { return operand.starts_with('-') ? "./" + operand : operand; }

std::vector<std::string> words_of(const Call& call) {
  std::vector<std::string> words{call.command};
  for (const std::string& operand : call.operands) words.push_back(operand_word(operand));
  for (const auto& [name, text] : call.options) {
    if (!text) {
      words.push_back("--" + name);
      continue;
    }
    for (std::string& word : shell::option_words(name, *text)) words.push_back(std::move(word));
  }
  return words;
}

/// The values of a command that these options describe.
template <class Options>
std::vector<shell::OptionValue> values_of(shell::CommandLine& line, const std::string& name) {
  Options options;
  shell::Command command = line.add(name, "", "");
  options.add_to(command);
  return command.values();
}

}  // namespace

void carry_out(const Call& call, const Describe& describe) {
  refuse_terminal_options(call);
  shell::CommandLine line("", "csgsim");
  describe(line);
  line.run(words_of(call), {});
}

std::vector<shell::OptionValue> options_of(const std::string& command) {
  shell::CommandLine line("", "csgsim");
  if (command == "render") return values_of<calls::RenderOptions>(line, command);
  if (command == "compile") return values_of<shell::ModelOptions>(line, command);
  if (command == "run") return values_of<calls::RunProgramOptions>(line, command);
  if (command == "explain") return values_of<calls::ExplainOptions>(line, command);
  const auto studies = studies::all();
  const auto row = std::ranges::find_if(studies, [&](const auto* one) { return one->name == command; });
  if (row == studies.end()) throw shell::UsageError("there is no '" + command + "' that can be called");
  return studies::describe_for_caller(line, **row)->command.values();
}

}  // namespace csgsim::python
