#pragma once

#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::test {

/// A random model for use inside a property, seen by a random camera, compiled for a machine that divides models
/// itself, with that machine's picture size. Models that the host rejects are skipped.
isa::Program any_divided_program(const machines::Machine& machine);

}  // namespace csgsim::test
