#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hw/base/error.h"
#include "hw/base/input_file.h"
#include "hw/base/output_file.h"
#include "hw/base/text.h"
#include "hw/bit_serial_memory/command_set.h"
#include "hw/bit_serial_memory/kind.h"
#include "sim/app/commands/commands.h"
#include "sim/engine/engine.h"
#include "sim/rows/trace.h"
#include "sim/session/model/model_request.h"
#include "sim/session/model/program_of.h"
#include "sim/session/model/subject.h"
#include "sim/session/options/paths.h"
#include "sim/session/run/memory.h"
#include "sim/session/run/run_request.h"

namespace csgsim::app {

namespace {

struct Options {
  ModelRequest model;
  std::string form = "csgsim";
  std::string command_set;
  std::string output;
};

constexpr InputKind command_set_file{
    .what = "a .toml file", .max_bytes = std::size_t{1} << 20U, .advice = "a command set has at most 64 commands"};

std::optional<bit_serial_memory::CommandSet> read_set(const std::string& file) {
  if (file.empty()) return std::nullopt;
  return bit_serial_memory::read_command_set(read_file(file, command_set_file), file);
}

void print_summary(const Options& options, const rows::TraceSummary& summary) {
  fmt::print("{}: {} row commands in {} lines of {}; {} clocks and {} until the picture is shown\n",
             printable(options.output), grouped(summary.commands), grouped(summary.lines), options.form,
             grouped(summary.timing.shown_clocks),
             quantity(static_cast<double>(summary.timing.account.count("frame_picojoules")) * 1e-12, "J"));
  for (const rows::Replacement& one : summary.replacements) {
    fmt::print("  {} cannot express {} {}; it contains {} instead\n", options.form, grouped(one.count), one.what,
               one.instead);
  }
}

void write_rows(const Options& options, const OptionList& command) {
  if (!is_model(options.model.model))
    refuse_model_options(command, {"machine", "set", "form", "command-set", "output"});
  std::vector<std::filesystem::path> inputs = options.model.inputs();
  if (!options.command_set.empty()) inputs.emplace_back(options.command_set);
  refuse_clashes(inputs, std::to_array<std::filesystem::path>({options.output}));
  OutputFile file(options.output);
  const std::optional<bit_serial_memory::CommandSet> set = read_set(options.command_set);
  const ProgramOnMachine subject = program_of(options.model, command);
  if (subject.machine.kind != &bit_serial_memory::kind) {
    throw InputError(subject.machine.name +
                     " has no row commands; choose a machine of kind bit-serial-memory, as --machine simdram-ddr4");
  }
  const engine::RunResult result = with_memory_for_run({&subject.program, 1}, subject.machine.array, [&] {
    return engine::make_functional_engine(subject.machine)->run(subject.program, {});
  });
  refuse_overflow(result);
  const rows::TraceSummary summary = rows::write_trace(
      subject.program, subject.machine, engine::run_outcome(result), rows::form_named(options.form),
      [&](std::string_view text) { file.write(text); }, set ? &*set : nullptr);
  file.commit();
  print_summary(options, summary);
}

void add_rows(CommandLine& line) {
  const auto options = std::make_shared<Options>();
  Command& command = line.add(
      "rows", run_group,
      "Write the row commands of a run on a memory that computes, with their clocks, for other tools",
      "Example:\n"
      "  csgsim rows tests/models/thesis_fig_2_3.csg --machine simdram-ddr4 --size 64x48 -o fig.rows\n"
      "  csgsim rows tests/models/thesis_fig_2_3.csg --machine simdram-ddr4 --size 64x48 --form drampower -o fig.csv");
  options->model.add_to(command, "The model (.csg, .scad or .jan) or a Program (.csgt)");
  command
      .option("--form", options->form,
              "Text form: csgsim is complete; ramulator2, drampower and drampower4 list DRAM commands; dramsim3 and "
              "ramulator2-accesses list reads and writes")
      .one_of(rows::form_names(), "form");
  command.option("--command-set", options->command_set,
                 "A .toml file with your own commands for the gates at the sense amplifiers (docs/row-traces.md)");
  command.option("-o,--output", options->output, "The trace, or - for standard output").required().check(not_empty);
  command.add_quiet_option();
  command.set_action([options, &command] { write_rows(*options, command); });
}

}  // namespace

extern const CommandRow rows_row{.name = "rows", .add = add_rows};

}  // namespace csgsim::app
