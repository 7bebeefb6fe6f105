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

void ProgramRequest::add_to(OptionList& options) {
  options.option("PROGRAM", program, "The Program, .csgt or its text form").required();
  options
      .option("--machine", machine,
              "A machine's name or .toml file, instead of the machine the Program was compiled for; its array is "
              "made as large as the Program's")
      .check(check_by_parsing(check_machine));
  add_parameter_sets(options, sets, "the machine");
  run.add_to(options);
  checkpoints.add_to(options);
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

/// Files that a checkpoint must not replace. The resumed checkpoint may be overwritten.
std::vector<std::filesystem::path> protected_files(const ProgramRequest& request) {
  std::vector<std::filesystem::path> files = request.inputs();
  for (const std::string& file : {request.run.picture, request.run.depth, request.run.owner, request.run.stats})
    if (!file.empty()) files.emplace_back(file);
  return files;
}

/// The hash that the Program's file would have.
std::string hash_of(const isa::Program& program) {
  const std::vector<std::byte> bytes = isa::encode(program);
  Hash hash;
  hash.add({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  return hash.text();
}

}  // namespace

void refuse_misuse(const ProgramRequest& request) {
  refuse_scene_sets(request.sets);
  request.checkpoints.check(request.run.level, protected_files(request));
}

LoadedProgram load(const ProgramRequest& request, const ContentReplacement& in_place) {
  isa::Program program = in_place.program ? *in_place.program : read_program(request.program);
  machines::Machine machine = machine_for(program, request.program, request.machine, request.sets);
  LoadedProgram loaded{std::move(machine), std::move(program), request.inputs()};
  if (in_place.program == nullptr) return loaded;
  loaded.hash = hash_of(loaded.program);
  loaded.is_in_place = true;
  return loaded;
}

Advice advice_of(const ProgramRequest& request, const machines::Machine& machine) {
  return {request.machine.empty() ? machine.name : request.machine, request.run.advice,
          "--advice tries machine parameters; that of csgsim render also settings and prunings"};
}

}  // namespace csgsim::session
