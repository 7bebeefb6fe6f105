// Conditions on watched fields.
// Used by session.cpp and stops.cpp.
#pragma once

#include <cstdint>
#include <string>

#include "sim/debug/command.h"
#include "sim/engine/run.h"

namespace csgsim::debug {

/// Whether the instruction can change E at any pixel.
bool changes_enable(isa::Opcode opcode);

/// Whether the instruction can change the watched field.
bool can_change(const isa::Instruction& instruction, isa::Field watched);

/// Value of the watched field at a pixel of the run's segment.
std::uint32_t read_value(const WatchedField& watched, const engine::Run& run);

/// Whether a value satisfies the condition; `previous_value` is the one at the previous boundary.
bool holds(const Condition& condition, std::uint32_t value, std::uint32_t previous_value);

/// Text of a command's operand: the field's name or its place; E for a field of width 0.
std::string to_text(isa::Field field, const isa::Program& program);
std::string to_text(const WatchedField& watched, const isa::Program& program);
std::string to_text(const Target& target, const isa::Program& program);

}  // namespace csgsim::debug
