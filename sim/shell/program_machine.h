#pragma once

#include <string>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::shell {

/// The machine that is meant where none is named.
inline constexpr const char* usual_machine = "pixel-planes-4";

/// The machine that runs a Program of that file, with the figures that are set and the array that the Program is for:
/// the one that the Program names, or `asked`, if that is not empty. Says on standard error in what the machine that is
/// asked for differs, and what is assumed of a Program that names none. Throws InputError where the machine is of
/// another kind than the Program's or has less memory, and as load_machine does.
machines::Machine machine_for(const isa::Program& program, const std::string& file, const std::string& asked,
                              const std::vector<std::string>& sets);

}  // namespace csgsim::shell
