#include <array>
#include <filesystem>
#include <iostream>
#include <memory>
#include <sstream>

#include "hw/base/output_file.h"
#include "hw/isa/text.h"
#include "sim/app/commands/commands.h"
#include "sim/shell/options.h"
#include "sim/shell/paths.h"
#include "sim/shell/program_of.h"
#include "sim/shell/subject.h"

namespace csgsim::app {

void add_disasm(CommandLine& line) {
  struct Options {
    std::string program;
    std::string output;
  };
  const auto options = std::make_shared<Options>();
  Command command = line.add("disasm", "Show a Program as text, which csgsim run reads too",
                             "Example:\n  csgsim disasm traces/carburettor.csgt | head -40");
  command.option("PROGRAM", options->program, "The Program, .csgt or its text form").required();
  command.option("-o,--output", options->output, "The text file; standard output if not given").check(not_empty);
  command.runs([options] {
    refuse_model(options->program);
    refuse_clashes(std::to_array<std::filesystem::path>({options->program}),
                   std::to_array<std::filesystem::path>({options->output}));
    const isa::Program program = read_program(options->program);
    if (options->output.empty()) {
      isa::print(std::cout, program);
      return;
    }
    std::ostringstream text;
    isa::print(text, program);
    write_file(options->output, text.view());
  });
}

}  // namespace csgsim::app
