// Loads machines by name, file or Program record.
// Used by sim.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hw/machines/machine.h"
#include "hw/machines/names.h"

namespace csgsim::kinds {

/// Names of the built-in machines.
std::vector<std::string_view> built_in_names();

/// Names of the built-in machines that studies include by default.
std::vector<std::string_view> studied_names();

/// The file of a machine description; empty if the machine is built in.
using machines::file_of;

/// Loads a built-in machine by name, or a description file (any name that ends in .toml). Changed parameters may
/// follow, `NAME+KEY=VALUE+KEY=VALUE`; `changes` are applied after them. A file with the name of a built-in machine but
/// other parameters is an edited machine: its name lists the edits. Throws InputError for an unknown name (and suggests
/// the nearest one), an unknown key, a wrong type or a value out of range, each with file:line:column; throws
/// machines::ChangeError for a wrong change.
machines::Machine load(const std::string& machine, const std::vector<std::string>& changes = {});

/// Loads the machine recorded in a Program, without its original file: a built-in machine with the recorded parameters,
/// or a machine of the recorded kind, for which all parameters must be recorded. `changes` are applied last. Throws
/// like the other load().
machines::Machine load(const isa::MachineRecord& record, const std::vector<std::string>& changes = {});

}  // namespace csgsim::kinds
