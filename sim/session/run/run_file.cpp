#include "sim/session/run/run_file.h"

#include <span>

#include "hw/base/hash.h"
#include "hw/isa/binary.h"
#include "sim/session/model/program_of.h"
#include "sim/session/model/subject.h"
#include "sim/session/options/paths.h"
#include "sim/session/options/read_by.h"
#include "sim/session/options/sets.h"

namespace csgsim::session {

void ProgramRequest::add_to(OptionList& command) {
  command.option("PROGRAM", program, "The Program, .csgt or its text form").required();
  command
      .option("--machine", machine,
              "A machine's name or its .toml file, in place of the one that the Program was compiled for; it gets "
              "the array the Program is for")
      .check(is_read_by(check_machine));
  add_figure_sets(command, sets, "the machine");
  run.add_to(command);
  checkpoints.add_to(command);
}

std::vector<std::filesystem::path> ProgramRequest::inputs() const {
  if (machine.empty()) return input_files({program}, {});
  return input_files({program}, {machine});
}

std::vector<std::filesystem::path> ProgramRequest::files_read() const {
  std::vector<std::filesystem::path> files = inputs();
  if (!checkpoints.resume.empty()) files.emplace_back(checkpoints.resume);
  return files;
}

namespace {

/// Files that a checkpoint may not take the place of. The one that is resumed may be written again.
std::vector<std::filesystem::path> others(const ProgramRequest& options) {
  std::vector<std::filesystem::path> files = options.inputs();
  for (const std::string& file : {options.run.picture, options.run.depth, options.run.owner, options.run.stats})
    if (!file.empty()) files.emplace_back(file);
  return files;
}

/// As that of its file would be.
std::string hash_of(const isa::Program& program) {
  const std::vector<std::byte> bytes = isa::encode(program);
  Hash hash;
  hash.add({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  return hash.text();
}

}  // namespace

void refuse_misuse(const ProgramRequest& options) {
  refuse_scene_sets(options.sets);
  options.checkpoints.check(options.run.level, others(options));
}

Loaded load(const ProgramRequest& options, const InPlace& in_place) {
  isa::Program program = in_place.program ? *in_place.program : read_program(options.program);
  machines::Machine machine = machine_for(program, options.program, options.machine, options.sets);
  Loaded loaded{std::move(machine), std::move(program), options.inputs()};
  if (in_place.program == nullptr) return loaded;
  loaded.hash = hash_of(loaded.program);
  loaded.is_in_place = true;
  return loaded;
}

Advice advice_of(const ProgramRequest& options, const machines::Machine& machine) {
  return {options.machine.empty() ? machine.name : options.machine, options.run.advice,
          "csgsim run --advice tries the machine's figures, csgsim render --advice settings too"};
}

}  // namespace csgsim::session
