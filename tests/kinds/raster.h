#pragma once

#include <memory>

#include "hw/machines/kind.h"
#include "hw/systemc/clocked_machine.h"

/// A kind of machine that no other room knows: one processor, which carries out each instruction at one pixel after the
/// other. A room of hw has this as kind.h and make.h, and `kind` as an object of its class.
namespace csgsim::raster {

extern const machines::Kind& kind;

std::unique_ptr<systemc::ClockedMachine> make_machine(const machines::Machine& machine);

}  // namespace csgsim::raster
