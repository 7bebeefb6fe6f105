#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <vector>

#include "host/convex/near_faces.h"
#include "hw/base/output_file.h"
#include "hw/base/text.h"
#include "hw/isa/binary.h"
#include "hw/isa/program.h"
#include "sim/app/commands/commands.h"
#include "sim/session/model/compiled_model.h"
#include "sim/session/model/model_request.h"
#include "sim/session/options/numbers.h"
#include "sim/session/options/paths.h"
#include "sim/session/options/progress.h"

namespace csgsim::app {

namespace {

void add_compile(CommandLine& line) {
  struct Options {
    ModelRequest model;
    std::string output;
  };
  const auto options = std::make_shared<Options>();
  Command& command =
      line.add("compile", everyday_group, "Compile a CSG model into a Program file, which runs without the model",
               "Example:\n  csgsim compile carburettor.csg -o carburettor.csgt\n  csgsim run carburettor.csgt -o "
               "carburettor.png");
  options->model.add_to(command);
  command.option("-o,--output", options->output, "The Program file, .csgt").required().check(not_empty);
  command.add_quiet_option();
  command.set_action([options] {
    refuse_clashes(options->model.inputs(), std::to_array<std::filesystem::path>({options->output}));
    refuse_terminal("--output", options->output);
    OutputFile file(options->output);
    const CompiledModel model = compile_model(options->model, machine_of(options->model));
    convex::warn_of_near_faces(model.tree, model.scene, options->model.snap);
    const isa::Program& program = model.program;
    const std::vector<std::byte> bytes = isa::encode(program);
    file.write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    file.commit();
    fmt::print("{}: {} for {} x {} pixels\n", printable(options->output),
               count_text(isa::total_instructions(program), "instruction"), program.shape.width, program.shape.height);
  });
}

}  // namespace

extern const CommandRow compile_row{.name = "compile", .add = add_compile};

}  // namespace csgsim::app
