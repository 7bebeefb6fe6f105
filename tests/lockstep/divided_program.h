#pragma once

#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::test {

/// Inside a property: a random model, seen by a random camera, compiled for a machine that divides it itself. The
/// picture is the machine's. Models that the host refuses are passed over.
isa::Program any_divided_program(const machines::Machine& machine);

}  // namespace csgsim::test
