#pragma once

#include <algorithm>
#include <cstdint>

#include "hw/bit_serial_memory/figures.h"
#include "hw/machines/machine.h"

namespace csgsim::bit_serial_memory {

/// Layout of a picture in the subarrays: pixel y * width + x is in column (y * width + x) mod row_columns of slot (y *
/// width + x) / row_columns. A slot is one subarray of each chip; these work in lockstep. Slots are assigned to the
/// banks round-robin.
struct Slots {
  std::uint64_t pixels = 0;
  std::uint64_t row_columns = 1;  ///< columns of a slot
  std::uint32_t banks = 1;

  [[nodiscard]] constexpr std::uint64_t count() const { return (pixels + row_columns - 1) / row_columns; }
  /// Number of columns of a slot that hold a pixel.
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
  const auto& figures = machines::kind_figures<Figures>(machine);
  return {std::uint64_t{machine.picture.width} * machine.picture.height,
          std::uint64_t{figures.chips} * figures.row_bits, figures.banks};
}

/// Clocks to transfer `bits` bits between a slot's row and the host, at the rate of the slower of bus and host.
constexpr std::uint64_t transfer_clocks(std::uint64_t bits, const Figures& figures) {
  const std::uint64_t bits_a_clock =
      std::min<std::uint64_t>(std::uint64_t{figures.bus_bits} * figures.chips, figures.plane_bits);
  return (bits + bits_a_clock - 1) / bits_a_clock;
}

}  // namespace csgsim::bit_serial_memory
