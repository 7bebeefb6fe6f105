#include "hw/pixel_planes/completion.h"

#include "hw/systemc/array_view.h"

namespace csgsim::pixel_planes {

Completion::Completion(sc_core::sc_module_name name) : sc_core::sc_module(name) {
  SC_HAS_PROCESS(Completion);
  SC_METHOD(complete);
  dont_initialize();
  sensitive << retired << accounts.data_written();
}

void Completion::begin(std::span<const isa::Segment> segments) {
  segments_ = segments;
  segments_begun_ = 0;
  skipped_ = 0;
  skips_.clear();
  answers_.clear();
}

void Completion::resume(std::uint32_t segment, std::uint32_t index) {
  segments_begun_ = segment + 1;
  index_ = index;
}

/// The account of a global-OR test arrives after the step of the test has reached the pixels. The account of any other
/// command arrives before the last word of the command.
void Completion::complete() {
  Account account;
  if (reported_ == retired.read() || !accounts.nb_read(account)) return;
  ++reported_;
  if (account.cleared) {
    ++segments_begun_;
    index_ = 0;
  } else {
    report(account);
  }
  enabled_ = enable->count_enabled();
  finish_segment();
}

void Completion::report(const Account& account) {
  if (account.answered) answers_.push_back(account.answer);
  retirement->after_instruction({.segment = segments_begun_ - 1,
                                 .index = index_,
                                 .clocks = account.clocks,
                                 .enabled_pixels = enabled_,
                                 .skipped = account.skipped},
                                systemc::ArrayView(enable->pixels()));
  if (account.skipped > 0) skips_.push_back({segments_begun_ - 1, index_});
  skipped_ += account.skipped;
  index_ += static_cast<std::uint32_t>(1 + account.skipped);
}

void Completion::finish_segment() {
  const std::uint32_t segment = segments_begun_ - 1;
  if (index_ != segments_[segment].instructions.size()) return;
  retirement->after_segment(segment, systemc::ArrayView(enable->pixels()));
}

}  // namespace csgsim::pixel_planes
