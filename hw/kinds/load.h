#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hw/machines/machine.h"
#include "hw/machines/names.h"

namespace csgsim::kinds {

/// Names of the machines that come with csgsim.
std::vector<std::string_view> built_in_names();

/// Of these, the ones on which studies of several machines draw where none is named.
std::vector<std::string_view> studied_names();

/// The file that describes the machine; empty if it is built in.
using machines::file_of;

/// A built-in machine by name, or one described in a file (anything ending in .toml). Figures may be changed behind it:
/// `NAME+KEY=VALUE+KEY=VALUE`, and `changes` are more of these. A file that gives a built-in machine's name to one of
/// other figures is an edited one: its name tells them too. Throws InputError: an unknown name (with the nearest one),
/// unknown key, wrong type, value out of range, each with file:line:column, or machines::ChangeError.
machines::Machine load(const std::string& machine, const std::vector<std::string>& changes = {});

/// The machine that a Program names, without the files that it may have come from: one that comes with csgsim, with the
/// figures that the Program says, or one of the kind that it says, of which it has to say all figures. `changes` are
/// made behind it. Throws as load does.
machines::Machine load(const isa::MachineRecord& record, const std::vector<std::string>& changes = {});

}  // namespace csgsim::kinds
