#pragma once

#include <memory>

#include "hw/machines/machine.h"
#include "sim/engine/engine.h"

/// One engine a kind of machine; all engines of a process share one machine, as SystemC elaborates once a process.
namespace csgsim::sim {

std::unique_ptr<Engine> make_pixel_planes_engine(const machines::Machine& machine);
std::unique_ptr<Engine> make_scan_line_engine(const machines::Machine& machine);
std::unique_ptr<Engine> make_pixel_square_engine(const machines::Machine& machine);

/// Throws std::logic_error unless the machine is the first of the process or the same hardware as that one.
void claim_elaboration(const machines::Machine& machine);

}  // namespace csgsim::sim
