// Text output of the debugger.
// Used by field_picture.cpp and session.cpp.
#pragma once

#include <cstdint>
#include <string>

#include "sim/debug/clocks.h"
#include "sim/debug/command.h"
#include "sim/engine/run.h"

namespace csgsim::debug {

/// Display properties derived from a field's role.
struct FieldMeaning {
  bool is_colour = false;
  bool is_depth = false;
};

/// The meaning of a field, from its role in the Program.
FieldMeaning field_meaning(isa::Field field, const isa::Program& program);

/// Text of a value according to its field's role: a colour, or a depth that may be empty.
std::string value_text(isa::Field field, std::uint32_t value, const isa::Program& program);

/// The next instruction with its purpose and its clocks, or the end of the run.
std::string where_text(const engine::Run& run, const isa::Program& program, Clocks& clocks);

/// `i12 of 345` and the instruction, on one line.
std::string place_text(const engine::Run& run, const isa::Program& program);

/// The instructions around the one with that number, which is marked.
std::string list_text(std::uint64_t number, const isa::Program& program);

std::string help_text();

}  // namespace csgsim::debug
