#include "hw/pixel_planes/host_link.h"

namespace csgsim::pixel_planes {

HostLink::HostLink(sc_core::sc_module_name name) : sc_core::sc_module(name) {
  SC_HAS_PROCESS(HostLink);
  SC_METHOD(fill);
  dont_initialize();
  sensitive << start_ << link.data_read();
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
  while (sending_ && link.num_free() > 0) {
    const HostWord word = next_word();
    link.nb_write(word);
    sending_ = !word.end;
  }
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
