#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>

#include "hw/base/error.h"
#include "hw/base/input_file.h"
#include "hw/base/inputs_kept.h"
#include "hw/base/messages.h"
#include "hw/base/standard_streams.h"
#include "hw/base/text.h"
#include "sim/app/commands/commands.h"
#include "sim/app/terminal.h"
#include "sim/debug/session.h"
#include "sim/session/model/model_request.h"
#include "sim/session/model/program_of.h"
#include "sim/session/model/subject.h"
#include "sim/session/options/numbers.h"
#include "sim/session/options/paths.h"
#include "sim/session/options/progress.h"
#include "sim/session/options/usage.h"
#include "sim/session/run/memory.h"
#include "sim/session/run/run_request.h"

namespace csgsim::app {

namespace {

struct Options {
  ModelRequest model;
  std::string commands;
  unsigned threads = 1;
};

constexpr InputKind command_file{"a file of commands", std::size_t{1} << 20U, "split it"};

/// Executes one line and prints its output. Throws InputError that begins with the line's place.
void execute(const std::string& text, const std::string& name, std::size_t line, const isa::Program& program,
             debug::Session& session) {
  const debug::Command& command = debug::parse_command(text, name, line, program);
  try {
    fmt::print("{}", session.execute(command));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}:{}: {}", name, line, error.what()));
  }
}

/// Reads the lines of a file or a pipe and echoes each before its output. The first invalid line ends the script.
void read_script(std::istream& lines, const std::string& name, const isa::Program& program, debug::Session& session) {
  std::string text;
  for (std::size_t line = 1; !session.is_over() && std::getline(lines, text); ++line) {
    if (text.ends_with('\r')) text.pop_back();
    if (!text.empty()) fmt::print("> {}\n", printable(text));
    std::fflush(stdout);  // the output precedes an error message
    execute(text, name, line, program, session);
  }
  std::fflush(stdout);
}

void read_terminal(const isa::Program& program, debug::Session& session) {
  Terminal terminal("> ", session.words());
  std::size_t line = 0;
  while (!session.is_over()) {
    const std::optional<std::string> text = terminal.read_line();
    if (!text) return static_cast<void>(fmt::print("\n"));
    try {
      execute(*text, "debug", ++line, program, session);
    } catch (const InputError& error) {
      std::fflush(stdout);
      report_line(error.what());
    }
    std::fflush(stdout);
  }
}

void run_debugger(const Options& options, const isa::Program& program, const machines::Machine& machine) {
  debug::Session session(program, machine, options.threads);
  if (!options.commands.empty()) {
    std::istringstream lines(read_file(options.commands, command_file));
    read_script(lines, options.commands, program, session);
  } else if (::isatty(STDIN_FILENO) != 0) {
    fmt::print("{}: {} on {}; help lists the commands\n", printable(shown_name(options.model.model)),
               count_text(engine::Numbers(program).count(), "instruction"), machine.name);
    read_terminal(program, session);
  } else {
    record_input(standard_input_file);
    read_script(std::cin, "standard input", program, session);
  }
}

void add_debug(CommandLine& line) {
  const auto options = std::make_shared<Options>();
  Command& command =
      line.add("debug", run_group, "Step forwards and backwards through a Program, with breakpoints",
               "Commands come from a file, from standard input or from the keyboard; `help` lists them.\n"
               "Example:\n  csgsim debug traces/thesis_fig_2_3.csgt -x commands.txt\n  echo 'until Z2[200,200] < "
               "1000000' | csgsim debug traces/thesis_fig_2_3.csgt");
  options->model.add_to(command, "The model (.csg, .scad or .jan) or a Program (.csgt)");
  command.option("-x,--commands", options->commands, "File with one command per line").check(not_empty);
  command.option("--threads", options->threads, "Worker threads; the states do not depend on their number")
      .between(1U, max_threads);
  command.set_action([options, &command] {
    if (options->model.model == standard_stream && options->commands.empty())
      throw UsageError(
          "MODEL", "standard input cannot hold both the Program and the commands; name a file of commands, -x FILE");
    if (!is_model(options->model.model)) refuse_model_options(command, {"machine", "set", "commands", "threads"});
    const ProgramOnMachine subject = program_of(options->model, command);
    const isa::Program& program = subject.program;
    with_memory_for_run({&program, 1}, program.shape, [&] { run_debugger(*options, program, subject.machine); });
  });
}

}  // namespace

extern const CommandRow debug_row{.name = "debug", .add = add_debug};

}  // namespace csgsim::app
