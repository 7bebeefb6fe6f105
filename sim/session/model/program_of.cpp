#include "sim/session/model/program_of.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <string_view>
#include <utility>

#include "hw/base/error.h"
#include "hw/base/messages.h"
#include "hw/base/standard_streams.h"
#include "hw/base/text.h"
#include "hw/isa/program_file.h"
#include "hw/machines/kind.h"
#include "sim/session/model/compiled_model.h"
#include "sim/session/model/subject.h"
#include "sim/session/options/paths.h"
#include "sim/session/options/sets.h"
#include "sim/session/options/usage.h"
#include "sim/session/run/memory.h"

namespace csgsim::session {

isa::Program read_program(const std::string& path) {
  try {
    return with_memory_for("the Program " + path, [&] { return isa::load_program(path); });
  } catch (const InputError& error) {
    const std::string_view message = error.what();
    const bool may_be_program = path == standard_stream || has_extension(path, ".csgt");
    if (may_be_program || message.find(": unknown instruction ") == message.npos) throw;
    throw InputError(fmt::format("{}; is this a Program? csgsim compile writes Programs, .csgt", message));
  }
}

namespace {

void refuse_less_memory(const isa::Program& program, const std::string& file, const machines::Machine& machine) {
  if (program.shape.memory_bits <= machine.array.memory_bits) return;
  throw InputError(
      fmt::format("{}: the Program needs {} memory bits per pixel, and {} has {}; use a machine with more, or compile "
                  "the model for this one",
                  file, program.shape.memory_bits, machine.name, machine.array.memory_bits));
}

/// The default machine, or the given one, for a Program that does not name its machine.
machines::Machine assumed_machine(const isa::Program& program, const std::string& file,
                                  const std::string& chosen_machine, const std::vector<std::string>& sets) {
  machines::Machine machine = load_machine(chosen_machine.empty() ? ModelRequest{}.machine : chosen_machine, sets);
  if (!chosen_machine.empty()) {
    refuse_less_memory(program, file, machine);
    return machine;
  }
  const std::uint32_t bits = program.shape.memory_bits;
  const std::string memory =
      bits > machine.array.memory_bits
          ? fmt::format(", with {} memory bits per pixel instead of {}", bits, machine.array.memory_bits)
          : "";
  report_line(
      fmt::format("{}: warning: the Program does not name the machine it was compiled for; {} is assumed{}; name one "
                  "with --machine",
                  file, machine.name, memory));
  return machine;
}

machines::Machine named_machine(const isa::Program& program, const std::string& file,
                                const std::vector<std::string>& sets) {
  try {
    return load_machine(program.machine, sets);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", file, error.what()));
  }
}

/// The machine that the Program names; nothing, with a warning, if it cannot be loaded.
std::optional<machines::Machine> find_named_machine(const isa::Program& program, const std::string& file) {
  try {
    return load_machine(program.machine, {});
  } catch (const InputError& error) {
    report_line(fmt::format("{}: warning: cannot check whether this machine fits: {}", file, error.what()));
    return std::nullopt;
  }
}

/// Checks whether a machine other than the one that the Program names can run it, and warns about differences.
void check_fits(const isa::Program& program, const std::string& file, const machines::Machine& machine) {
  const std::optional<machines::Machine> known = find_named_machine(program, file);
  if (!known) return refuse_less_memory(program, file, machine);
  const machines::Machine& own = *known;
  if (machine.kind != own.kind) {
    throw InputError(fmt::format(
        "{}: the Program was compiled for {}, of kind {}, and {} is of kind {}; leave --machine out, or compile the "
        "model for this one",
        file, own.name, own.kind->name, machine.name, machine.kind->name));
  }
  const std::vector<std::string> others = machines::figure_differences(machine, own);
  if (others.empty()) return;
  refuse_less_memory(program, file, machine);
  report_line(fmt::format(
      "{}: warning: the Program was compiled for {}; {} has {}; leave --machine out, or compile the model for it", file,
      own.name, machine.name, fmt::join(others, ", ")));
}

}  // namespace

machines::Machine machine_for(const isa::Program& program, const std::string& file, const std::string& chosen_machine,
                              const std::vector<std::string>& sets) {
  const std::string shown = printable(shown_name(file));
  if (program.machine.name.empty()) {
    machines::Machine machine = assumed_machine(program, shown, chosen_machine, sets);
    machines::adopt_shape(machine, program);
    return machine;
  }
  machines::Machine machine =
      chosen_machine.empty() ? named_machine(program, shown, sets) : load_machine(chosen_machine, sets);
  if (!chosen_machine.empty()) check_fits(program, shown, machine);
  machines::adopt_shape(machine, program);
  return machine;
}

void refuse_model_options(const OptionList& options, const std::set<std::string>& accepted_options,
                          const std::string& advice) {
  for (const GivenOption& option : options.given()) {
    if (option.name != "quiet" && !accepted_options.contains(option.name))
      throw UsageError("--" + option.name, "is for models; " + advice);
  }
}

ProgramOnMachine program_of(const ModelRequest& request, const std::string& chosen_machine) {
  if (is_model(request.model)) {
    machines::Machine machine = machine_of(request);
    isa::Program program = compile_model(request, machine).program;
    return {std::move(machine), std::move(program)};
  }
  refuse_scene_sets(request.sets);
  isa::Program program = read_program(request.model);
  machines::Machine machine = machine_for(program, request.model, chosen_machine, request.sets);
  return {std::move(machine), std::move(program)};
}

ProgramOnMachine program_of(const ModelRequest& request, const OptionList& options) {
  return program_of(request, options.is_given("machine") ? request.machine : "");
}

}  // namespace csgsim::session
