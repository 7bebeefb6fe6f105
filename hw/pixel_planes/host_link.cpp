#include "hw/pixel_planes/host_link.h"

namespace csgsim::pixel_planes {

HostLink::HostLink(sc_core::sc_module_name name) : sc_core::sc_module(name) {
  SC_HAS_PROCESS(HostLink);
  SC_METHOD(fill);
  dont_initialize();
  sensitive << start_ << link.data_read() << jumps.data_written();
}

void HostLink::send(std::span<const isa::Segment> segments) {
  segments_ = segments;
  segment_ = 0;
  index_ = 0;
  ordinal_ = 0;
  sending_ = true;
  start_.notify(sc_core::SC_ZERO_TIME);
}

void HostLink::fill() {
  if (std::uint64_t ordinal = 0; jumps.nb_read(ordinal)) go_on_from(ordinal);
  while (sending_ && link.num_free() > 0) {
    const HostWord word = next_word();
    link.nb_write(word);
    sending_ = !word.end;
  }
}

/// Instructions ahead of what has been sent are of the same segment; behind it, of this or one before.
void HostLink::go_on_from(std::uint64_t ordinal) {
  while (ordinal < ordinal_ - index_) {
    ordinal_ -= index_;
    index_ = segments_[--segment_].instructions.size();
  }
  index_ = static_cast<std::size_t>(ordinal - (ordinal_ - index_));
  ordinal_ = ordinal;
  sending_ = true;
}

HostWord HostLink::next_word() {
  while (segment_ < segments_.size() && index_ == segments_[segment_].instructions.size()) {
    ++segment_;
    index_ = 0;
  }
  if (segment_ == segments_.size()) return {.end = true, .ordinal = ordinal_, .instruction = {}};
  return {.end = false, .ordinal = ordinal_++, .instruction = segments_[segment_].instructions[index_++]};
}

}  // namespace csgsim::pixel_planes
