#include <fmt/format.h>

#include <memory>

#include "hw/isa/program_file.h"
#include "sim/app/commands.h"
#include "sim/app/model_options.h"

namespace csgsim::app {

void add_compile(CLI::App& app) {
  struct Options {
    ModelOptions model;
    std::string output;
  };
  const auto options = std::make_shared<Options>();
  CLI::App& command =
      *app.add_subcommand("compile", "Compile a CSG model into a Program file, to be run without the model");
  command.footer(
      "Example:\n  csgsim compile carburettor.csg -o carburettor.csgt --view-all\n  csgsim run carburettor.csgt -o "
      "carburettor.png");
  options->model.add_to(command);
  command.add_option("-o,--output", options->output, "The Program file, .csgt")->required();
  command.callback([options] {
    const isa::Program program = compile_model(options->model, machine_of(options->model)).program;
    isa::save_program(program, options->output);
    std::size_t instructions = 0;
    for (const isa::Segment& segment : program.segments) instructions += segment.instructions.size();
    fmt::print("{}: {} instructions for {} x {} pixels\n", options->output, instructions, program.shape.width,
               program.shape.height);
  });
}

}  // namespace csgsim::app
