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

/// What waves show of a pixel-square machine beside its renderers.
namespace csgsim::pixel_square {

/// `PART.state`, `.square` at hand, `.store_fill` in words.
std::vector<wave::Tap> divider_taps(const std::string& part, const CornerDivider& divider, const isa::Program& program);

/// Of what sends squares: `PART.state`, `.square` at hand, `.renderer` that gets it.
std::vector<wave::Tap> sender_taps(const std::string& part, const SenderStatus& status, const isa::Program& program);

/// `frame_buffer.state`, `.port` that is served, a renderer's number or behind these that of who has it clear;
/// `.square` that comes through it;
/// `.squares` that are whole.
std::vector<wave::Tap> frame_buffer_taps(const FrameBuffer& buffer, const isa::Program& program,
                                         const systemc::SegmentNames& names);

/// The taps of the same pixel as each renderer has them, as one: of the first that shows something.
std::vector<wave::Tap> of_whoever_shows(std::vector<std::vector<wave::Tap>> renderers);

/// Words in a FIFO.
template <class Word>
wave::Tap fill_tap(const std::string& name, const sc_core::sc_fifo<Word>& fifo) {
  return wave::number(name, 32, [&fifo] { return wave::Number(static_cast<std::uint64_t>(fifo.num_available())); });
}

}  // namespace csgsim::pixel_square
