#pragma once

#include <string>
#include <vector>

#include "hw/machines/machine.h"
#include "sim/session/options/option_list.h"

namespace csgsim::session {

/// What `--set KEY=VALUE` says, by what the key is of. No key is of both: a test sees to it.
struct Sets {
  std::vector<std::string> figures;  ///< of a machine, of whatever kind
  std::vector<std::string> scene;
};

/// Throws UsageError for a key that is of neither, with the nearest of both.
Sets sorted(const std::vector<std::string>& sets);

/// Throws InputError for a machine's name that is of none, or that changes a figure wrongly; files are not read.
void check_machine(const std::string& name);

/// The same for a list with commas.
void check_machines(const std::string& names);

/// The machine with its figures as set; keys of the scene do not matter. Throws InputError, or UsageError for a figure
/// that is set wrongly.
machines::Machine load_machine(const std::string& name, const std::vector<std::string>& sets);

/// The same of the machine that a Program names.
machines::Machine load_machine(const isa::MachineRecord& record, const std::vector<std::string>& sets);

/// The names of several machines, each with those of the set figures that machines of its kind have, as in
/// `pixel-planes-4+alu.bits=4`. Throws InputError, or UsageError for a figure that none of them has.
std::vector<std::string> with_figures(const std::vector<std::string>& names, const std::vector<std::string>& sets);

/// An option --set of a command that knows no scene. `which` says what of.
void add_figure_sets(OptionList& command, std::vector<std::string>& sets, const std::string& which);

/// Throws UsageError where a key of the scene is set, which has no meaning where nothing is compiled.
void refuse_scene_sets(const std::vector<std::string>& sets, const std::string& option = "--set");

}  // namespace csgsim::session
