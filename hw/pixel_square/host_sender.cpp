#include "hw/pixel_square/host_sender.h"

#include "hw/pixel_square/commands.h"

namespace csgsim::pixel_square {

HostSender::HostSender(sc_core::sc_module_name name, const machines::Machine& machine)
    : Sender(name, machine, machine.link.word_clocks),
      link_width_(machine.link.width),
      latency_(machine.link.latency) {}

void HostSender::begin(std::span<const isa::Segment> segments) {
  segments_ = segments;
  latency_left_ = latency_;
  begin_frame(segments.size());
}

std::optional<SquareActivity> HostSender::prepare(std::size_t /*square*/) {
  if (latency_left_ == 0) return std::nullopt;
  --latency_left_;
  return SquareActivity::waiting_for_host;
}

SquareStart HostSender::start(std::size_t square) {
  const isa::Segment& segment = segments_[square];
  words_ = encode_square(segment.region, segment.instructions, link_width_);
  next_ = 0;
  return {segment.region, words_.empty()};
}

}  // namespace csgsim::pixel_square
