#include "sim/app/study_commands.h"

#include <memory>
#include <string>

#include "sim/app/commands/commands.h"
#include "sim/studies/gather_command.h"
#include "sim/studies/runner.h"

namespace csgsim::app {

void add_study_command(shell::CommandLine& line, const studies::StudyRow& row) {
  shell::Command& command = line.add(row.name, row.group, row.does, std::string("Example:\n") + row.example);
  const std::shared_ptr<studies::StudyCommand> study = studies::add_study_options(command, row);
  command.add_quiet_option();
  command.set_action([study] { run_study(*study); });
}

void add_gather_command(shell::CommandLine& line, std::span<const studies::StudyRow* const> studies) {
  const auto request = std::make_shared<studies::GatherRequest>();
  shell::Command& command = line.add(
      "gather", study_group, "Join the shards of a study into the table, JSON and plots of an unsharded run",
      "Example:\n  csgsim sweep carburettor.csg --shard 1/2 -o out\n"
      "  csgsim sweep carburettor.csg --shard 2/2 -o out\n"
      "  csgsim gather out\n"
      "Shards may run at the same time, on any number of computers. A shard that was killed keeps its measurements;\n"
      "repeat its command to continue. docs/design-space.md has commands for Slurm, GNU Parallel and MPI launchers.");
  request->add_to(command);
  command.add_quiet_option();
  command.set_action([request, studies] { run_gather(studies, *request); });
}

}  // namespace csgsim::app
