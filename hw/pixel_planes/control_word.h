#pragma once

#include <concepts>
#include <cstdint>
#include <ostream>
#include <string>
#include <systemc>

#include "hw/array/linear_evaluator.h"
#include "hw/array/sequencer.h"
#include "hw/isa/program.h"
#include "hw/systemc/wire.h"

/// What travels between the modules, one value a clock.
namespace csgsim::pixel_planes {

/// Clears so many memory bits of every pixel from that address on, and all registers. Pixels right of `width` or below
/// `height` take no part until the next word that clears.
struct ClearStep {
  std::uint16_t address = 0;
  std::uint16_t bits = 0;
  std::uint16_t width = 0;   ///< pixels
  std::uint16_t height = 0;  ///< pixels

  constexpr bool operator==(const ClearStep&) const = default;
};

/// A memory bit of a row of pixels.
struct RefreshStep {
  std::uint16_t address = 0;
  std::uint16_t row = 0;

  constexpr bool operator==(const RefreshStep&) const = default;
};

/// Controller, through a delay line, to the pixels.
struct ControlWord {
  array::ArrayStep step{};
  bool steps = false;   ///< `step` is one of an instruction of the host's
  bool clears = false;  ///< the pixels obey `clear` and not `step`
  ClearStep clear{};
  bool refreshes = false;  ///< the scan-out latches the bit that `refresh` names; the pixels do nothing
  RefreshStep refresh{};
  bool last = false;          ///< word of its command
  std::uint64_t ordinal = 0;  ///< of the instruction within the frame, those skipped included

  constexpr bool operator==(const ControlWord&) const = default;
};

/// Controller to the scan-out: these bits of every pixel hold a finished picture.
struct FinishedPicture {
  isa::Field colour;
};

/// The wired OR of the enable bits, back to the controller.
struct Answer {
  bool valid = false;
  bool any_enabled = false;

  constexpr bool operator==(const Answer&) const = default;
};

/// What the controller counted for one instruction, or that a segment's pixels were cleared.
struct Account {
  bool cleared = false;
  std::uint64_t clocks = 0;
  bool answered = false;  ///< the instruction was a question of the host's
  bool answer = false;
  std::uint64_t skipped = 0;  ///< instructions after it that are not carried out
};

// Which nobody calls (hw/systemc/wire.h).
template <systemc::OneOf<Answer, RefreshStep, FinishedPicture, Account> Value>
std::ostream& operator<<(std::ostream& stream, const Value& /*value*/) {
  return stream;
}
template <std::same_as<Answer> Value>
void sc_trace(sc_core::sc_trace_file* /*file*/, const Value& /*value*/, const std::string& /*name*/) {}

}  // namespace csgsim::pixel_planes
