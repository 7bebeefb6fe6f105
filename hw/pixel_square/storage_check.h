#pragma once

#include <cstdint>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/pixel_square/figures.h"

namespace csgsim::pixel_square {

/// Whether a model of `model_bytes` bytes exceeds a divider's memory, so that its planes, of `plane_bits` bits each,
/// stay at the host and are read over the link (docs/machines/pixel-square.md).
bool has_remote_planes(std::uint64_t model_bytes, std::uint64_t plane_count, std::uint64_t plane_bits,
                       const Figures& figures);

/// Throws InputError, naming the parameter, unless a divider's memory can hold the model (without its planes if they
/// stay at the host) and the half-spaces and nodes that do not fit their own memories.
void check_storage(const isa::Program& program, const machines::Machine& machine);

/// Throws InputError unless the Program's segments match the division of its display model.
void check_division(const isa::Program& program, const machines::Machine& machine);

}  // namespace csgsim::pixel_square
