#pragma once

#include <cstdint>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/pixel_square/figures.h"

namespace csgsim::pixel_square {

/// Whether a model of so many bytes does not fit a divider's memory with its planes, each of so many bits: they stay
/// with the host then, and are read over the link (docs/machines/pixel-square.md).
bool has_far_planes(std::uint64_t model_bytes, std::uint64_t planes, std::uint64_t plane_bits, const Figures& figures);

/// Throws InputError, naming the figure, unless a divider's memory holds the model, if need be without its planes, and
/// what is at hand for a surface beyond the memories that are for that.
void check_storage(const isa::Program& program, const machines::Machine& machine);

/// Throws InputError unless the Program's segments are what its display model is divided into.
void check_division(const isa::Program& program, const machines::Machine& machine);

}  // namespace csgsim::pixel_square
