// Values on the wires between the modules.
// Used by hw/pixel_square.
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

// Values on the wires and in the FIFOs between the modules.
namespace csgsim::pixel_planes {

/// Clears `bits` memory bits of every pixel from `address` on, and all registers. Pixels right of `width` or below
/// `height` take no part until the next ClearStep.
struct ClearStep {
  std::uint16_t address = 0;
  std::uint16_t bits = 0;
  std::uint16_t width = 0;   ///< pixels
  std::uint16_t height = 0;  ///< pixels

  constexpr bool operator==(const ClearStep&) const = default;
};

/// Address of one memory bit of one row of pixels.
struct RefreshStep {
  std::uint16_t address = 0;
  std::uint16_t row = 0;

  constexpr bool operator==(const RefreshStep&) const = default;
};

/// Word that the controller sends through a delay line to the pixels.
struct ControlWord {
  array::ArrayStep step{};
  bool steps = false;   ///< whether `step` belongs to an instruction of the host
  bool clears = false;  ///< whether the pixels execute `clear` instead of `step`
  ClearStep clear{};
  bool refreshes = false;  ///< whether the scan-out latches the bit that `refresh` addresses, while the pixels are idle
  RefreshStep refresh{};
  bool last = false;          ///< whether this is the last word of its command
  std::uint64_t ordinal = 0;  ///< number of the instruction within the frame, including skipped ones

  constexpr bool operator==(const ControlWord&) const = default;
};

/// Message from the controller to the scan-out: the field `colour` holds a finished picture.
struct FinishedPicture {
  isa::Field colour;
};

/// Result of a global-OR test: the wired OR of the enable bits, on its way to the controller.
struct Answer {
  bool valid = false;
  bool any_enabled = false;

  constexpr bool operator==(const Answer&) const = default;
};

/// Counts of the controller for one instruction; if `cleared`, for the clearing of a segment's pixels.
struct Account {
  bool cleared = false;
  std::uint64_t clocks = 0;
  bool answered = false;      ///< whether the result of the global-OR test is sent to the host
  bool answer = false;        ///< this result
  std::uint64_t skipped = 0;  ///< number of instructions skipped after it
};

// Required by sc_signal and sc_fifo; never called (hw/systemc/wire.h).
template <systemc::OneOf<Answer, RefreshStep, FinishedPicture, Account> Value>
std::ostream& operator<<(std::ostream& stream, const Value& /*value*/) {
  return stream;
}
template <std::same_as<Answer> Value>
void sc_trace(sc_core::sc_trace_file* /*file*/, const Value& /*value*/, const std::string& /*name*/) {}

}  // namespace csgsim::pixel_planes
