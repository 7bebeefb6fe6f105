#pragma once

#include <cstdint>
#include <string>

#include "sim/debug/command.h"
#include "sim/engine/run.h"

namespace csgsim::debug {

/// Can the instruction change E at any pixel?
bool changes_enable(isa::Opcode opcode);

/// Can the instruction change what is watched?
bool can_change(const isa::Instruction& instruction, isa::Field watched);

/// What is watched, of a pixel in the run's segment.
std::uint32_t value_of(const Watched& what, const engine::Run& run);

/// Whether a value is as the condition asks; `before` is that of the boundary before.
bool holds(const Condition& condition, std::uint32_t value, std::uint32_t before);

/// As a command has it: the field's name, or its place; E for a field of width 0.
std::string text_of(isa::Field field, const isa::Program& program);
std::string text_of(const Watched& what, const isa::Program& program);
std::string text_of(const Target& target, const isa::Program& program);

}  // namespace csgsim::debug
