// The option --set: machine parameters and scene keys.
// Used by sim/app, sim/studies and sim/suite.
#pragma once

#include <string>
#include <vector>

#include "hw/machines/machine.h"
#include "sim/session/options/option_list.h"

namespace csgsim::session {

/// The settings of `--set KEY=VALUE`, by the owner of the key. A test checks that no key belongs to both.
struct Sets {
  std::vector<std::string> figures;  ///< parameters of a machine, of any kind
  std::vector<std::string> scene;    ///< keys of the scene
};

/// Divides the settings by the owner of their keys. Throws UsageError for a key that belongs to neither, with the
/// nearest key of both.
Sets divide_settings(const std::vector<std::string>& settings);

/// Throws InputError for an unknown machine name or an invalid parameter change in the name; files are not read.
void check_machine(const std::string& name);

/// check_machine() for each name of a comma-separated list.
void check_machines(const std::string& names);

/// The machine with the given parameters; scene keys are ignored. Throws InputError, or UsageError for an invalid
/// parameter.
machines::Machine load_machine(const std::string& name, const std::vector<std::string>& settings);

/// The machine that a Program names, with the given parameters. Throws InputError, or UsageError for an invalid
/// parameter.
machines::Machine load_machine(const isa::MachineRecord& record, const std::vector<std::string>& settings);

/// Appends to each machine name those parameters that machines of its kind have, as in `pixel-planes-4+alu.bits=4`.
/// Throws InputError, or UsageError for a parameter that none of them has.
std::vector<std::string> with_parameters(const std::vector<std::string>& names,
                                         const std::vector<std::string>& settings);

/// Adds --set to a command without a scene. `machine` describes the machine in the help text.
void add_parameter_sets(OptionList& command, std::vector<std::string>& settings, const std::string& machine);

/// Throws UsageError if a scene key is set: for commands that compile nothing.
void refuse_scene_sets(const std::vector<std::string>& settings, const std::string& option = "--set");

}  // namespace csgsim::session
