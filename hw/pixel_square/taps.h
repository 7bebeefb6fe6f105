#pragma once

#include <string>
#include <systemc>
#include <vector>

#include "hw/isa/program.h"
#include "hw/pixel_square/corner_divider.h"
#include "hw/pixel_square/frame_buffer.h"
#include "hw/pixel_square/sender.h"
#include "hw/systemc/segment_names.h"
#include "hw/wave/request.h"
#include "hw/wave/tap.h"

/// Wave taps of a pixel-square machine, except those of its renderers.
namespace csgsim::pixel_square {

/// Taps `PART.state`, `.square` (in progress) and `.store_fill` (in words).
std::vector<wave::Tap> divider_taps(const std::string& part, const CornerDivider& divider, const isa::Program& program);

/// Taps of a sender: `PART.state`, `.square` (in progress) and `.renderer` (the destination).
std::vector<wave::Tap> sender_taps(const std::string& part, const SenderStatus& status, const isa::Program& program);

/// Taps of the frame buffer: `frame_buffer.state`; `.port`, the port being served (the renderers' ports come first,
/// then the ports for squares to clear); `.square`, the square that arrives through that port; `.squares`, the number
/// of complete squares; `.refreshed_row`.
std::vector<wave::Tap> frame_buffer_taps(const FrameBuffer& buffer, const isa::Program& program,
                                         const systemc::SegmentNames& names);

/// Merges the renderers' taps of the same pixel: each shows the value of the first renderer that has one.
std::vector<wave::Tap> merge_taps(std::vector<std::vector<wave::Tap>> renderers);

/// Tap of the number of words in a FIFO.
template <class Word>
wave::Tap fill_tap(const std::string& name, const sc_core::sc_fifo<Word>& fifo) {
  return wave::number(name, 32, [&fifo] { return wave::Number(static_cast<std::uint64_t>(fifo.num_available())); });
}

}  // namespace csgsim::pixel_square
