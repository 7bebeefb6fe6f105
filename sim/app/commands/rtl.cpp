#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hw/base/error.h"
#include "hw/base/messages.h"
#include "hw/base/output_folder.h"
#include "hw/base/standard_streams.h"
#include "hw/base/text.h"
#include "sim/app/commands/commands.h"
#include "sim/rtl/design.h"
#include "sim/session/model/model_request.h"
#include "sim/session/model/program_of.h"
#include "sim/session/model/subject.h"
#include "sim/session/options/numbers.h"
#include "sim/session/options/paths.h"
#include "sim/session/options/progress.h"
#include "sim/session/options/read_by.h"
#include "sim/session/options/sets.h"
#include "sim/session/options/usage.h"

namespace csgsim::app {

namespace {

namespace fs = std::filesystem;

struct Options {
  ModelRequest model;
  std::string output;
};

/// Above so many pixels simulators of Verilog take minutes to build the machine, and hours to draw.
constexpr std::uint64_t many_pixels = 4096;

struct Subject {
  machines::Machine machine;
  std::optional<isa::Program> program;
};

/// Where there is no model.
void refuse_what_is_for_models(const ModelRequest& options, const OptionList& command) {
  const std::string mend = "name one behind the machine";
  refuse_model_options(command, {"size", "memory-bits", "set", "output"}, mend);
  const std::vector<std::string> of_scene = sorted(options.sets).scene;
  if (!of_scene.empty())
    throw UsageError("--set", fmt::format("'{}' is for models; {}", printable(of_scene.front()), mend));
}

Subject subject_of(const Options& options, const OptionList& command) {
  if (options.model.model.empty()) {
    refuse_what_is_for_models(options.model, command);
    return {machine_of(options.model), std::nullopt};
  }
  if (!is_model(options.model.model)) refuse_model_options(command, {"set", "output"});
  ProgramOnMachine both = program_of(options.model, options.model.machine);
  return {std::move(both.machine), std::move(both.program)};
}

/// All of them, or none.
void write_files(const fs::path& path, const std::vector<rtl::DesignFile>& files) {
  OutputFolder folder(path);
  for (const rtl::DesignFile& file : files) folder.write(file.path, file.content);
  folder.commit();
}

void warn_of_size(const machines::Machine& machine) {
  if (std::uint64_t{machine.array.width} * machine.array.height <= many_pixels) return;
  tell_line(
      fmt::format("csgsim: warning: {} x {} pixels are many for simulators of Verilog and more than small FPGAs hold; "
                  "--size 16x16 makes fewer",
                  machine.array.width, machine.array.height));
}

void write_design(const Options& options, const OptionList& command) {
  const fs::path folder = options.output;
  if (is_standard_output(folder)) throw UsageError("--output", "a design is several files; name a folder");
  const Subject subject = subject_of(options, command);
  const std::vector<rtl::DesignFile> files =
      rtl::design_files(subject.machine, subject.program ? &*subject.program : nullptr);
  std::vector<fs::path> paths;
  paths.reserve(files.size());
  for (const rtl::DesignFile& file : files) paths.push_back(folder / file.path);
  refuse_clashes(options.model.inputs(), paths);
  write_files(folder, files);
  warn_of_size(subject.machine);
  fmt::print("{}: {} of {}, {} x {} pixels{}; {}\n", printable(options.output), counted(files.size(), "file"),
             subject.machine.name, subject.machine.array.width, subject.machine.array.height,
             subject.program ? " with a Program" : "",
             subject.program ? "make -C " + shell_word(options.output) + " icarus draws the picture"
                             : "make -C " + shell_word(options.output) + " ice40 places and routes it");
}

void add_rtl(CommandLine& line) {
  const auto options = std::make_shared<Options>();
  Command& command =
      line.add("rtl", hardware,
               "Write a machine as Verilog: a design to simulate and to put on an FPGA, with a Program in its memory",
               "Example:\n  csgsim rtl pixel-planes-4 tests/models/thesis_fig_2_3.csg --size 16x16 -o design\n"
               "  make -C design icarus ice40\nWhat is in the folder, and what fits on which FPGA: docs/hardware.md.");
  command
      .option("MACHINE", options->model.machine,
              "A machine's name (see csgsim manual machines) or its .toml file; with figures changed: NAME+KEY=VALUE")
      .required()
      .check(is_read_by(check_machine));
  options->model.add_to(command);
  command.remove("MODEL");
  command.remove("--machine");
  command.option(
      "MODEL", options->model.model,
      "A model, .csg, its source, .scad, or commands, .jan; or a Program, .csgt; without it the machine is fed "
      "over a serial line");
  command
      .option("-o,--output", options->output,
              "The folder of the design: a new one, an empty one, or a design's that is replaced as a whole")
      .required()
      .check(not_empty)
      .folder();
  command.prints_summary();
  command.runs([options, &command] { write_design(*options, command); });
}

}  // namespace

extern const CommandRow rtl_row{.name = "rtl", .add = add_rtl};

}  // namespace csgsim::app
