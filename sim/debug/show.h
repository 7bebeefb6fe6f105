#pragma once

#include <cstdint>
#include <string>

#include "sim/debug/clocks.h"
#include "sim/debug/command.h"
#include "sim/engine/run.h"

namespace csgsim::debug {

// What the debugger prints, in lines that end with one.

/// How the role of a field asks for it to be shown.
struct FieldMeaning {
  bool is_colour = false;
  bool is_depth = false;
};

FieldMeaning meaning_of(isa::Field field, const isa::Program& program);

/// A value as its field's role asks: a colour, a depth that is nothing.
std::string value_text(isa::Field field, std::uint32_t value, const isa::Program& program);

/// The next instruction, whom it serves and its clocks; or that the run is over.
std::string where_text(const engine::Run& run, const isa::Program& program, Clocks& clocks);

/// `i12 of 345` and the instruction, on one line.
std::string place_text(const engine::Run& run, const isa::Program& program);

/// The instructions around the one of that number, which is marked.
std::string list_text(std::uint64_t number, const isa::Program& program);

std::string help_text();

}  // namespace csgsim::debug
