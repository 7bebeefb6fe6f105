// Interfaces of the pixel pipeline.
// Used by the modules of hw/pixel_planes and hw/pixel_square.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <systemc>

#include "hw/array/pixel_array.h"
#include "hw/pixel_planes/control_word.h"

namespace csgsim::pixel_planes {

/// Wires from a controller to the roots of the multiplier trees and to the delay line before the pixels.
class PixelWires : virtual public sc_core::sc_interface {
 public:
  /// Sets the wires from `edge` on, until the edge of the next call. `edge` must not precede the current edge or the
  /// edge of the previous call.
  virtual void put(std::uint64_t edge, const ControlWord& word, const array::RootBits& bits) = 0;
};

/// The refresh port, which reads one memory bit of one row of pixels.
class RefreshPort : virtual public sc_core::sc_interface {
 public:
  /// One memory bit of one row, valid until the next read.
  [[nodiscard]] virtual std::span<const std::uint64_t> memory_row(std::uint32_t address, std::uint32_t row) const = 0;

  /// The refresh word executed by the pixels at the last edge; empty if there was none, or if the machine sends no
  /// refresh words.
  [[nodiscard]] virtual std::optional<RefreshStep> refreshed() const { return std::nullopt; }
};

/// Access to the enable bits, and to all pixels for observers of the run.
class EnableLines : virtual public sc_core::sc_interface {
 public:
  [[nodiscard]] virtual bool any_enabled() const = 0;
  [[nodiscard]] virtual std::uint64_t count_enabled() const = 0;

  [[nodiscard]] virtual const array::PixelArray& pixels() const = 0;
};

}  // namespace csgsim::pixel_planes
