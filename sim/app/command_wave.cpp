#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "hw/base/error.h"
#include "hw/base/output_file.h"
#include "hw/base/pipe_into.h"
#include "hw/base/text.h"
#include "sim/app/commands.h"
#include "sim/app/memory.h"
#include "sim/app/model_options.h"
#include "sim/app/numbers.h"
#include "sim/app/paths.h"
#include "sim/app/program_input.h"
#include "sim/app/run_options.h"
#include "sim/app/usage.h"
#include "sim/app/wave_view.h"
#include "sim/cycle/record.h"

namespace csgsim::app {

namespace {

struct Options {
  ModelOptions model;
  std::vector<std::string> probes;
  std::string window = "0:2000";
  std::string output;
};

/// A Program has been compiled: what says how to compile has no meaning for it.
void refuse_model_options(const Command& command) {
  const std::set<std::string> own{"machine", "probe", "window", "output"};
  for (const GivenOption& option : command.given()) {
    if (!own.contains(option.name))
      throw UsageError("--" + option.name, "is for models; a Program has been compiled already");
  }
}

/// A model is compiled; anything else is a Program, and the machine gets the array it is made for.
isa::Program program_of(const ModelOptions& options, machines::Machine& machine) {
  if (is_model(options.model)) return compile_model(options, machine).program;
  isa::Program program = read_program(options.model);
  machines::adopt(machine, program);
  return program;
}

kernel::WaveRequest request_of(const Options& options, const isa::Program& program, const std::filesystem::path& file) {
  kernel::WaveRequest request;
  request.file = file;
  const auto window = numbers<std::uint64_t>(options.window, ':', 2, "--window", "FIRST:END");
  request.begin = window[0];
  request.end = window[1];
  if (request.begin >= request.end) throw UsageError("--window", "the window's end has to come after its first clock");
  for (const std::string& text : options.probes) {
    const auto place = numbers<std::uint32_t>(text, ',', 2, "--probe", "x,y");
    if (place[0] >= program.shape.width || place[1] >= program.shape.height) {
      throw UsageError("--probe", fmt::format("there is no pixel {} in a picture of {} x {}", text, program.shape.width,
                                              program.shape.height));
    }
    request.probes.push_back({place[0], place[1]});
  }
  request.fields = program.facts.fields;
  return request;
}

void record(const Options& options, const Command& command) {
  if (!ends_in(options.output, ".vcd")) {
    throw UsageError("--output", "the waveform's name has to end in .vcd");
  }
  if (!is_model(options.model.model)) refuse_model_options(command);
  const std::filesystem::path view_path = std::filesystem::path(options.output).replace_extension(".gtkw");
  refuse_clashes(options.model.inputs(), std::to_array<std::filesystem::path>({options.output, view_path}));
  OutputFile file(options.output);
  OutputFile view(view_path);
  machines::Machine machine = machine_of(options.model);
  const isa::Program program = program_of(options.model, machine);
  PipeInto pipe(file, ".vcd");
  const kernel::WaveRequest request = request_of(options, program, pipe.path());
  const sim::RecordedRun run =
      with_memory_for_picture(machine.array, [&] { return sim::run_and_record(machine, program, {}, request); });
  if (!run.window_reached) {
    throw InputError(
        fmt::format("the program ends at clock {}, before the window {} begins; choose an earlier --window",
                    run.result.clocks, options.window));
  }
  refuse_overflow(run.result);
  pipe.finish();
  view.write(gtkwave_view(request, options.output, machine));
  commit_all(std::array{&file, &view});
  fmt::print("{}: clocks {} of {}, {} pixels; to look at it: gtkwave {}\n", printable(options.output), options.window,
             run.result.clocks, request.probes.size(), shell_word(view_path.native()));
}

}  // namespace

void add_wave(CommandLine& line) {
  const auto options = std::make_shared<Options>();
  Command command = line.add(
      "wave", "Record the machine's wires and some pixels over a window of clocks",
      "Example:\n  csgsim wave traces/thesis_fig_2_3.csgt --probe 200,300 --window 0:3000 -o fig_2_3.vcd\n  gtkwave "
      "fig_2_3.vcd");
  options->model.add_to(command);
  command.option("--probe", options->probes, "A pixel to look into, x,y; may be given several times").required();
  command.option("--window", options->window, "Clocks to record, FIRST:END, END not included");
  command.option("-o,--output", options->output, "The waveform, .vcd").required();
  command.runs([options, command] { record(*options, command); });
}

}  // namespace csgsim::app
