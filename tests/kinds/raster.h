#pragma once

#include <memory>

#include "hw/machines/kind.h"
#include "hw/systemc/clocked_machine.h"

/// A kind of machine unknown elsewhere: one processor, which executes each instruction at one pixel after the other. A
/// kind in hw declares `kind` in kind.h, as an object of its class, and has a KIND_maker (hw/systemc/maker.h) for its
/// SystemC model.
namespace csgsim::raster {

extern const machines::Kind& kind;

std::unique_ptr<systemc::ClockedMachine> make_machine(const machines::Machine& machine);

}  // namespace csgsim::raster
