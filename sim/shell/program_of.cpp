#include "sim/shell/program_of.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "sim/shell/paths.h"
#include "sim/shell/program_input.h"
#include "sim/shell/program_machine.h"
#include "sim/shell/settings/sets.h"
#include "sim/shell/subject.h"
#include "sim/shell/usage.h"

namespace csgsim::shell {

void refuse_model_options(const Command& command, const std::set<std::string>& own) {
  for (const GivenOption& option : command.given()) {
    if (option.name != "quiet" && !own.contains(option.name))
      throw UsageError("--" + option.name, "is for models; a Program has been compiled already");
  }
}

ProgramOnMachine program_of(const ModelOptions& options, const std::string& asked) {
  if (is_model(options.model)) {
    machines::Machine machine = machine_of(options);
    isa::Program program = compile_model(options, machine).program;
    return {std::move(machine), std::move(program)};
  }
  refuse_scene_sets(options.sets);
  isa::Program program = read_program(options.model);
  machines::Machine machine = machine_for(program, options.model, asked, options.sets);
  return {std::move(machine), std::move(program)};
}

ProgramOnMachine program_of(const ModelOptions& options, const Command& command) {
  return program_of(options, is_given(command, "machine") ? options.machine : "");
}

bool is_given(const Command& command, std::string_view name) {
  const std::vector<GivenOption> given = command.given();
  return std::any_of(given.begin(), given.end(), [&](const GivenOption& one) { return one.name == name; });
}

}  // namespace csgsim::shell
