#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <systemc>

#include "hw/array/linear_evaluator.h"
#include "hw/array/sequencer.h"
#include "hw/isa/instruction.h"

/// What travels on the wires between the modules, one value a clock.
namespace csgsim::pixel_planes {

/// Host to controller: one instruction, or the end of the program.
struct HostWord {
  bool end = false;
  std::uint64_t ordinal = 0;  ///< within the program
  isa::Instruction instruction;
};

/// Controller to the roots of the multiplier trees.
struct RootWord {
  array::RootBits bits;

  constexpr bool operator==(const RootWord&) const = default;
};

/// Controller, through a delay line, to the pixels.
struct ControlWord {
  array::ArrayStep step;
  bool last = false;          ///< step of its instruction
  std::uint64_t ordinal = 0;  ///< of the instruction within the program

  constexpr bool operator==(const ControlWord&) const = default;
};

/// The wired OR of the enable bits, back to the controller.
struct Answer {
  bool valid = false;
  bool any_enabled = false;

  constexpr bool operator==(const Answer&) const = default;
};

/// What the controller counted for one instruction.
struct Account {
  std::uint64_t clocks = 0;
  bool answered = false;  ///< the instruction was a question of the host's
  bool answer = false;
  std::uint64_t skipped = 0;  ///< instructions after it that are not carried out
};

std::ostream& operator<<(std::ostream& stream, const HostWord& word);
std::ostream& operator<<(std::ostream& stream, const RootWord& word);
std::ostream& operator<<(std::ostream& stream, const ControlWord& word);
std::ostream& operator<<(std::ostream& stream, const Answer& answer);
std::ostream& operator<<(std::ostream& stream, const Account& account);

void sc_trace(sc_core::sc_trace_file* file, const RootWord& word, const std::string& name);
void sc_trace(sc_core::sc_trace_file* file, const ControlWord& word, const std::string& name);
void sc_trace(sc_core::sc_trace_file* file, const Answer& answer, const std::string& name);

}  // namespace csgsim::pixel_planes
