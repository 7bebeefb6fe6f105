#pragma once

#include <algorithm>
#include <cstdint>

#include "hw/bit_serial_memory/figures.h"
#include "hw/machines/machine.h"

namespace csgsim::bit_serial_memory {

/// How a picture lies in the subarrays: pixel y * width + x in column c of slot s, where c counts the columns of as
/// many subarrays as there are chips, one of each, which work in step. Slots are dealt out to the banks in turn.
struct Slots {
  std::uint64_t pixels = 0;
  std::uint64_t row_columns = 1;  ///< of a slot
  std::uint32_t banks = 1;

  [[nodiscard]] constexpr std::uint64_t count() const { return (pixels + row_columns - 1) / row_columns; }
  /// Columns of a slot that hold a pixel.
  [[nodiscard]] constexpr std::uint64_t columns(std::uint64_t slot) const {
    return std::min(row_columns, pixels - slot * row_columns);
  }
  [[nodiscard]] constexpr std::uint32_t bank(std::uint64_t slot) const {
    return static_cast<std::uint32_t>(slot % banks);
  }
  [[nodiscard]] constexpr std::uint32_t used_banks() const {
    return static_cast<std::uint32_t>(std::min<std::uint64_t>(banks, count()));
  }
};

inline Slots slots_of(const machines::Machine& machine) {
  const auto& figures = machines::own<Figures>(machine);
  return {std::uint64_t{machine.picture.width} * machine.picture.height,
          std::uint64_t{figures.chips} * figures.row_bits, figures.banks};
}

/// Clocks in which that many bits pass between a slot's row and the host, or the host works them out.
constexpr std::uint64_t transfer_clocks(std::uint64_t bits, const Figures& figures) {
  const std::uint64_t bits_a_clock =
      std::min<std::uint64_t>(std::uint64_t{figures.bus_bits} * figures.chips, figures.plane_bits);
  return (bits + bits_a_clock - 1) / bits_a_clock;
}

}  // namespace csgsim::bit_serial_memory
