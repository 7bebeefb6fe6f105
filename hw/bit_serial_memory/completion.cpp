#include "hw/bit_serial_memory/completion.h"

namespace csgsim::bit_serial_memory {

void Completion::begin(std::span<const isa::Segment> segments) {
  segments_ = segments;
  begun_ = 0;
  index_ = 0;
  skipped_ = 0;
  answers_.clear();
}

void Completion::after_clear() {
  ++begun_;
  index_ = 0;
  finish_segment();
}

void Completion::after_instruction(std::uint64_t clocks, std::optional<bool> answer, std::uint64_t skipped) {
  if (answer) answers_.push_back(*answer);
  retirement->after_instruction(
      {.segment = begun_ - 1, .index = index_, .clocks = clocks, .enabled_pixels = enabled_, .skipped = skipped},
      pixels_);
  skipped_ += skipped;
  index_ += static_cast<std::uint32_t>(1 + skipped);
  finish_segment();
}

void Completion::finish_segment() {
  if (index_ == segments_[begun_ - 1].instructions.size()) retirement->after_segment(begun_ - 1, pixels_);
}

}  // namespace csgsim::bit_serial_memory
