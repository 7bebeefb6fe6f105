#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <systemc>
#include <vector>

#include "hw/isa/program.h"
#include "hw/scan_line/cell_chain.h"
#include "hw/scan_line/chain_link.h"
#include "hw/scan_line/line_host.h"
#include "hw/scan_line/packet.h"
#include "hw/scan_line/packet_queue.h"
#include "hw/scan_line/packet_signals.h"
#include "hw/scan_line/refresh_collector.h"
#include "hw/wave/request.h"
#include "hw/wave/tap.h"

/// Wave taps of a scan-line array.
namespace csgsim::scan_line {

/// A chain with its link, and its index in the collector.
struct ChainParts {
  const ChainLink& link;
  const sc_core::sc_fifo<isa::LinkWord>& words;
  const PacketQueue& queue;
  const sc_core::sc_signal<Beat>& entry;
  const CellChain& chain;
  const sc_core::sc_signal<RefreshPixel>& refresh;
  const RefreshCollector& collector;
  std::size_t number = 0;
};

/// Form of a packet's words.
struct WordShape {
  CellShape cell{};
  unsigned degree = 1;   ///< degree of the expressions
  bool in_cells = true;  ///< whether words of difference and sum reach the cells (trees deliver the value instead)
};

/// Taps `host.activity` and `.line`, the row of the picture.
std::vector<wave::Tap> host_taps(const LineHost& host, const isa::Program& program);

/// Taps `link.activity`, `.line` and `.fill`, the number of words in the FIFO after the link; `entry.activity` and the
/// packet at the entry; `refresh.line` and `.colour` at the port. `suffix` is appended to the names of the units.
std::vector<wave::Tap> chain_taps(const std::string& suffix, const ChainParts& parts, const isa::Program& program,
                                  WordShape shape);

/// Taps of the cell of a probed pixel while it processes the pixel's line: the packet in the cell, the sum of the
/// received words of F `.sum`, `.enable`, and one tap per field. Throws InputError for a pixel that is in no line.
std::vector<wave::Tap> cell_taps(wave::Pixel pixel, std::span<const ChainParts> chains, const isa::Program& program,
                                 WordShape shape);

}  // namespace csgsim::scan_line
