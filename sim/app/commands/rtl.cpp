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

/// Above this number of pixels, Verilog simulators take minutes to build the machine and hours to draw.
constexpr std::uint64_t many_pixels = 4096;

struct Subject {
  machines::Machine machine;
  std::optional<isa::Program> program;
};

/// Rejects options of models when the command line names a machine only.
void refuse_model_only_options(const ModelRequest& options, const OptionList& command) {
  const std::string fix = "name one after the machine";
  refuse_model_options(command, {"size", "memory-bits", "set", "output"}, fix);
  const std::vector<std::string> of_scene = divide_settings(options.sets).scene;
  if (!of_scene.empty()) throw UsageError("--set", fmt::format("'{}' is for models; {}", of_scene.front(), fix));
}

Subject subject_of(const Options& options, const OptionList& command) {
  if (options.model.model.empty()) {
    refuse_model_only_options(options.model, command);
    return {machine_of(options.model), std::nullopt};
  }
  if (!is_model(options.model.model)) refuse_model_options(command, {"set", "output"});
  ProgramOnMachine both = program_of(options.model, options.model.machine);
  return {std::move(both.machine), std::move(both.program)};
}

/// Writes all files, or none on an error.
void write_files(const fs::path& path, const std::vector<rtl::DesignFile>& files) {
  OutputFolder folder(path);
  for (const rtl::DesignFile& file : files) folder.write(file.path, file.content);
  folder.commit();
}

void warn_of_size(const machines::Machine& machine) {
  if (std::uint64_t{machine.array.width} * machine.array.height <= many_pixels) return;
  report_line(
      fmt::format("csgsim: warning: {} x {} pixels are slow in Verilog simulators and too many for small FPGAs; use "
                  "fewer, as with --size 16x16",
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
  fmt::print("{}: {} of {}, {} x {} pixels{}; {}\n", printable(options.output), count_text(files.size(), "file"),
             subject.machine.name, subject.machine.array.width, subject.machine.array.height,
             subject.program ? " with a Program" : "",
             subject.program ? "make -C " + shell_word(options.output) + " icarus draws the picture"
                             : "make -C " + shell_word(options.output) + " ice40 places and routes it");
}

void add_rtl(CommandLine& line) {
  const auto options = std::make_shared<Options>();
  Command& command = line.add(
      "rtl", hardware_group, "Write a machine as Verilog for simulation and FPGAs, with a Program in its memory",
      "Example:\n  csgsim rtl pixel-planes-4 tests/models/thesis_fig_2_3.csg --size 16x16 -o design\n"
      "  make -C design icarus ice40\ndocs/hardware.md describes the folder and which designs fit on which FPGA.");
  command
      .option("MACHINE", options->model.machine,
              "A machine's name (see csgsim manual machines) or .toml file; NAME+KEY=VALUE changes a parameter")
      .required()
      .check([](const std::string& name) {
        return has_model_name(name)
                   ? "'" + name + "' is a model; name the machine first, as in csgsim rtl MACHINE MODEL"
                   : check_by_parsing(check_machine)(name);
      });
  options->model.add_to(command);
  command.remove("MODEL");
  command.remove("--machine");
  command.option("MODEL", options->model.model,
                 "A model (.csg, .scad or .jan) or a Program (.csgt); without it the machine receives its words over a "
                 "serial line");
  command
      .option("-o,--output", options->output,
              "Folder for the design: new, empty, or that of an earlier design, which is replaced")
      .required()
      .folder();
  command.add_quiet_option();
  command.set_action([options, &command] { write_design(*options, command); });
}

}  // namespace

extern const CommandRow rtl_row{.name = "rtl", .add = add_rtl};

}  // namespace csgsim::app
