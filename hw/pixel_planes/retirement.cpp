#include "hw/pixel_planes/retirement.h"

namespace csgsim::pixel_planes {

Retirement::Retirement(sc_core::sc_module_name name) : sc_core::sc_module(name) {
  SC_HAS_PROCESS(Retirement);
  SC_METHOD(retire);
  dont_initialize();
  sensitive << retired;
}

void Retirement::begin(std::span<const isa::Segment> segments, RunListener& listener) {
  segments_ = segments;
  listener_ = &listener;
  segment_ = 0;
  index_ = 0;
  enabled_ = 0;
  skipped_ = 0;
  answers_.clear();
  guard_.begin();
  if (!segments_.empty()) enable->reset(segments_.front().region);
  finish_segments();
}

void Retirement::retire() {
  Account account;
  if (!accounts.nb_read(account)) SC_REPORT_FATAL("csgsim", "an instruction was carried out that nobody accounted for");
  if (account.answered) answers_.push_back(account.answer);
  tell(account);
  enabled_ = enable->count_enabled();
  skipped_ += account.skipped;
  index_ += static_cast<std::uint32_t>(1 + account.skipped);
  finish_segments();
}

void Retirement::tell(const Account& account) {
  guard_.run([&] {
    listener_->after_instruction({.segment = segment_,
                                  .index = index_,
                                  .clocks = account.clocks,
                                  .enabled_pixels = enabled_,
                                  .skipped = account.skipped});
  });
}

/// Goes on to the next segment that has an instruction to come.
void Retirement::finish_segments() {
  while (segment_ < segments_.size() && index_ == segments_[segment_].instructions.size()) {
    guard_.run([&] { listener_->after_segment(segment_); });
    ++segment_;
    index_ = 0;
    if (segment_ == segments_.size()) return;
    enabled_ = 0;
    enable->reset(segments_[segment_].region);
  }
}

}  // namespace csgsim::pixel_planes
