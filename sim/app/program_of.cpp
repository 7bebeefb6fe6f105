#include "sim/app/program_of.h"

#include "sim/app/paths.h"
#include "sim/app/program_input.h"
#include "sim/app/settings/sets.h"
#include "sim/app/usage.h"

namespace csgsim::app {

void refuse_model_options(const Command& command, const std::set<std::string>& own) {
  for (const GivenOption& option : command.given()) {
    if (option.name != "quiet" && !own.contains(option.name))
      throw UsageError("--" + option.name, "is for models; a Program has been compiled already");
  }
}

isa::Program program_of(const ModelOptions& options, machines::Machine& machine) {
  if (is_model(options.model)) return compile_model(options, machine).program;
  refuse_scene_sets(options.sets);
  isa::Program program = read_program(options.model);
  machines::adopt(machine, program);
  return program;
}

}  // namespace csgsim::app
