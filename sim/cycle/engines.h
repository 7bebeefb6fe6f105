#pragma once

#include <memory>

#include "hw/machines/machine.h"
#include "sim/engine/engine.h"

namespace csgsim::sim {

/// SystemC elaborates once a process: all engines of a process share one machine. Throws std::logic_error if the
/// process has elaborated other hardware.
void claim_kernel(const machines::Machine& machine);

/// The engines of make_cycle_engine, by machines::Kind.
std::unique_ptr<Engine> make_pixel_planes_engine(const machines::Machine& machine);
std::unique_ptr<Engine> make_scan_line_engine(const machines::Machine& machine);

}  // namespace csgsim::sim
