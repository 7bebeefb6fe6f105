#pragma once

#include <cstdint>

#include "hw/machines/accounts.h"
#include "hw/machines/machine.h"
#include "hw/scan_line/activity.h"

namespace csgsim::scan_line {

/// Counts of a scan-line array in one frame. Clocks are counted from the first clock in which the host works. A line
/// consists of one packet per instruction, one more packet if clearing takes clocks, and a final mark.
struct LineAccount {
  std::uint64_t lines = 0;
  std::uint64_t packets = 0;      ///< packets of instructions
  std::uint64_t max_packets = 0;  ///< packets of the line with the most packets
  /// Clocks that the refresh allows for a line: its time per line times the number of chains.
  std::uint64_t line_budget = 0;
  /// Number of lines whose mark entered more than line_budget after the previous mark of the chain.
  std::uint64_t late_lines = 0;
  std::uint64_t link_words = 0;
  std::uint64_t entry_clocks = 0;    ///< clocks in which a packet or mark was entering a chain, summed over the chains
  std::uint64_t refresh_clocks = 0;  ///< clocks in which a mark waited for the refresh path, summed over the chains
  std::uint64_t fill_clocks = 0;     ///< clocks until a packet or mark first reached the last cell of a line
  std::uint64_t drain_clocks = 0;  ///< clocks from the last mark's entry until the last colour was at the refresh port
  std::uint64_t busy_cells =
      0;  ///< clocks in which an instruction's packet occupied a cell, summed over the lines' cells
  LineClocks host{};
  LineClocks link{};     ///< clocks of the link of the chain that ends last
  LineClocks entry{};    ///< clocks of the entry of that chain
  LineClocks refresh{};  ///< clocks of the refresh of that chain

  bool operator==(const LineAccount&) const = default;
};

/// Converts the counts of a frame of `frame_clocks` clocks to the account that statistics and reports show.
machines::Account account(const LineAccount& counts, const machines::Machine& machine, std::uint64_t frame_clocks);

}  // namespace csgsim::scan_line
