#include <array>
#include <filesystem>
#include <iostream>
#include <memory>
#include <sstream>

#include "hw/base/error.h"
#include "hw/base/output_file.h"
#include "hw/bit_serial_memory/kind.h"
#include "hw/bit_serial_memory/row_text.h"
#include "hw/isa/text.h"
#include "sim/app/commands/commands.h"
#include "sim/session/model/program_of.h"
#include "sim/session/model/subject.h"
#include "sim/session/options/paths.h"
#include "sim/session/options/progress.h"

namespace csgsim::app {

namespace {

void print_rows(std::ostream& out, const isa::Program& program, const std::string& file) {
  const machines::Machine machine = machine_for(program, file, "", {});
  if (machine.kind != &bit_serial_memory::kind) {
    throw InputError(file + ": the Program is for " + machine.name +
                     ", which has no row commands; compile the model for a machine of kind bit-serial-memory");
  }
  bit_serial_memory::print_row_commands(out, program, machine);
}

void add_disasm(CommandLine& line) {
  struct Options {
    std::string program;
    std::string output;
    bool row_commands = false;
  };
  const auto options = std::make_shared<Options>();
  Command& command = line.add("disasm", run_group, "Print a Program as text, which csgsim run also accepts",
                              "Example:\n  csgsim disasm traces/carburettor.csgt | head -40");
  command.option("PROGRAM", options->program, "The Program, .csgt or its text form").required();
  command.option("-o,--output", options->output, "The text file; default: standard output").check(not_empty);
  command.flag("--row-commands", options->row_commands,
               "Print the row commands of a bit-serial-memory machine instead, one per line, for other simulators");
  command.set_action([options] {
    refuse_model(options->program);
    refuse_clashes(std::to_array<std::filesystem::path>({options->program}),
                   std::to_array<std::filesystem::path>({options->output}));
    const isa::Program program = read_program(options->program);
    const auto print = [&](std::ostream& out) {
      if (options->row_commands)
        print_rows(out, program, options->program);
      else
        isa::print(out, program);
    };
    if (options->output.empty()) return print(std::cout);
    std::ostringstream text;
    print(text);
    write_file(options->output, text.view());
  });
}

}  // namespace

extern const CommandRow disasm_row{.name = "disasm", .add = add_disasm};

}  // namespace csgsim::app
