#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <systemc>

#include "hw/array/pixel_array.h"
#include "hw/pixel_planes/control_word.h"

namespace csgsim::pixel_planes {

/// The wires from a controller to the roots of the multiplier trees and to the delay before the pixels.
class PixelWires : virtual public sc_core::sc_interface {
 public:
  /// They carry this from that edge on, until the edge of the next that is put. The edge is the one at hand or a later
  /// one, and no earlier than that of the one before.
  virtual void put(std::uint64_t edge, const ControlWord& word, const array::RootBits& bits) = 0;
};

/// The refresh port: one memory bit of one row of pixels, valid until the next is asked for.
class RefreshPort : virtual public sc_core::sc_interface {
 public:
  [[nodiscard]] virtual std::span<const std::uint64_t> memory_row(std::uint32_t address, std::uint32_t row) const = 0;

  /// What a refresh word names that was at the pixels in the clock before this edge; where there are no such words,
  /// none.
  [[nodiscard]] virtual std::optional<RefreshStep> refreshed() const { return std::nullopt; }
};

/// The enable bits, and the pixels for who watches the run.
class EnableLines : virtual public sc_core::sc_interface {
 public:
  [[nodiscard]] virtual bool any_enabled() const = 0;
  [[nodiscard]] virtual std::uint64_t count_enabled() const = 0;

  [[nodiscard]] virtual const array::PixelArray& pixels() const = 0;
};

}  // namespace csgsim::pixel_planes
