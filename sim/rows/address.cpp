#include "sim/rows/address.h"

#include <algorithm>

namespace csgsim::rows {

std::uint32_t row_in_bank(bit_serial_memory::Row row, std::uint64_t slot, const Frame& frame) {
  return static_cast<std::uint32_t>(slot / frame.slots.banks) * frame.figures.subarray_rows + row;
}

std::uint64_t burst_bytes(const Frame& frame) {
  return std::max<std::uint64_t>(1, std::uint64_t{frame.figures.chips} * frame.figures.bus_bits * burst_clocks / 8);
}

std::vector<std::uint64_t> burst_commands(const Issue& issue, const Frame& frame) {
  const std::uint64_t bits = 8 * burst_bytes(frame);
  const std::uint64_t count = (frame.slots.columns(issue.place) + bits - 1) / bits;
  const std::uint64_t gap = std::max(burst_clocks, issue.transfer_clocks / count);
  std::vector<std::uint64_t> clocks;
  for (std::uint64_t i = 0; i < count; ++i)
    clocks.push_back(issue.transfer - frame.figures.command.column / 2 + i * gap);
  return clocks;
}

}  // namespace csgsim::rows
