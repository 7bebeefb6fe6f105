#pragma once

#include <rapidcheck.h>

#include <cstddef>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::rtl {

/// One to three consecutive valid Programs for the machine, with at most `instructions` per segment and equally wide
/// colours, or in one of four cases no colours. They leave the bits of a second buffer unused.
rc::Gen<std::vector<isa::Program>> arbitrary_frames(const machines::Machine& machine, std::size_t instructions);

}  // namespace csgsim::rtl
