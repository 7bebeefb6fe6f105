#pragma once

#include <rapidcheck.h>

#include <cstddef>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::rtl {

/// Valid Programs for the machine that follow each other, one to three, with so many instructions a segment at most and
/// equally wide colours; one in four times with none. They leave out the bits of a second buffer.
rc::Gen<std::vector<isa::Program>> arbitrary_frames(const machines::Machine& machine, std::size_t instructions);

}  // namespace csgsim::rtl
