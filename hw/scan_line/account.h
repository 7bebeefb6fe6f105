#pragma once

#include <cstdint>

#include "hw/machines/accounts.h"
#include "hw/machines/machine.h"
#include "hw/scan_line/activity.h"

namespace csgsim::scan_line {

/// How the frame of a scan-line array went by. Clocks count from the first in which the host works. A line is packets,
/// one an instruction and, where clearing takes clocks, one for that, and ends with a mark.
struct LineAccount {
  std::uint64_t lines = 0;
  std::uint64_t packets = 0;       ///< of instructions
  std::uint64_t most_packets = 0;  ///< of a line
  std::uint64_t line_budget = 0;   ///< clocks that the refresh gives a line, times the chains that share the lines
  std::uint64_t late_lines = 0;    ///< whose mark entered more than that after the mark before it in the chain
  std::uint64_t link_words = 0;
  std::uint64_t entry_clocks = 0;    ///< in which a packet or mark was entering a chain, summed over the chains
  std::uint64_t refresh_clocks = 0;  ///< in which a mark waited for the refresh path, summed over the chains
  std::uint64_t fill_clocks = 0;     ///< until a packet or mark was in the last cell of a line for the first time
  std::uint64_t drain_clocks = 0;    ///< from the last mark's entry until the last colour was at the refresh port
  std::uint64_t busy_cells =
      0;  ///< clocks in which an instruction's packet occupied a cell, summed over the lines' cells
  LineClocks host{};
  LineClocks link{};     ///< of the chain that ends last
  LineClocks entry{};    ///< of that chain
  LineClocks refresh{};  ///< of that chain

  bool operator==(const LineAccount&) const = default;
};

/// As it is told of a frame of so many clocks.
machines::Account account(const LineAccount& counted, const machines::Machine& machine, std::uint64_t clocks);

}  // namespace csgsim::scan_line
