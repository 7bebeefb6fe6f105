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

/// What waves show of a scan-line array.
namespace csgsim::scan_line {

/// A chain with its link, and its number among the collector's.
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

/// What the words of a packet are like.
struct WordShape {
  CellShape cell{};
  unsigned degree = 1;   ///< of the expressions
  bool in_cells = true;  ///< words of difference and sum come to the cells; else a tree makes of them what comes
};

/// `host.activity`, `.line`: the row of the picture.
std::vector<wave::Tap> host_taps(const LineHost& host, const isa::Program& program);

/// `link.activity`, `.line`, `.fill` of the FIFO behind it; `entry.activity`, the packet at the entry; `refresh.line`,
/// `.colour` at the port. `suffix` comes behind the names of the parts.
std::vector<wave::Tap> chain_taps(const std::string& suffix, const ChainParts& parts, const isa::Program& program,
                                  WordShape shape);

/// The cell of a probed pixel, while it works on the pixel's line: the packet that is in it, `.sum` of the words of F
/// that have come in, `.enable`, and a tap a field. Throws InputError for a pixel that no line holds.
std::vector<wave::Tap> cell_taps(wave::Pixel pixel, std::span<const ChainParts> chains, const isa::Program& program,
                                 WordShape shape);

}  // namespace csgsim::scan_line
