#include "sim/python/call.h"

#include <algorithm>
#include <array>
#include <memory>
#include <string_view>

#include "hw/base/standard_streams.h"
#include "sim/session/model/model_request.h"
#include "sim/session/options/option_table.h"
#include "sim/session/options/usage.h"
#include "sim/session/run/explain.h"
#include "sim/session/run/render.h"
#include "sim/session/run/run_file.h"
#include "sim/studies/rows.h"
#include "sim/studies/runner.h"

namespace csgsim::python {

namespace {

/// Options of every command that make sense only on a terminal.
constexpr auto of_terminals = std::to_array<std::string_view>({"help", "dump-config"});

void refuse_terminal_options(const Call& call) {
  for (const auto& [name, text] : call.options) {
    const bool is_of_terminals = std::ranges::find(of_terminals, name) != of_terminals.end();
    if (is_of_terminals) throw session::UsageError("--" + name, "only the command line has this option; leave it out");
    const bool is_output = session::known_option(name).role == session::FileRole::output;
    if (is_output && text && is_standard_output(*text))
      throw session::UsageError("--" + name, "name a file; the call returns what the command line would print");
  }
}

/// An operand that begins with a dash is still a file name.
std::string operand_word(const std::string& operand) { return operand.starts_with('-') ? "./" + operand : operand; }

/// The options and operands of a command, with their values.
template <class Request>
std::vector<session::OptionValue> values_of(const std::string& name) {
  Request request;
  session::OptionList list(name);
  request.add_to(list);
  return list.values();
}

}  // namespace

void give(const Call& call, session::OptionList& options) {
  refuse_terminal_options(call);
  for (const std::string& operand : call.operands) options.give_operand(operand_word(operand));
  for (const auto& [name, text] : call.options) {
    if (text) {
      options.give(name, *text);
    } else {
      options.give_flag(name);
    }
  }
  options.check_and_apply();
}

std::vector<session::OptionValue> command_options(const std::string& command) {
  if (command == "render") return values_of<session::RenderRequest>(command);
  if (command == "compile") return values_of<session::ModelRequest>(command);
  if (command == "run") return values_of<session::ProgramRequest>(command);
  if (command == "explain") return values_of<session::ExplainRequest>(command);
  const auto studies = studies::all();
  const auto row = std::ranges::find_if(studies, [&](const auto* one) { return one->name == command; });
  if (row == studies.end())
    throw session::UsageError("there is no command or study '" + command + "'; csgsim.studies() lists the studies");
  session::OptionList list(command);
  return studies::add_library_study_options(list, **row)->command.values();
}

}  // namespace csgsim::python
