#include "hw/scan_line/line_retirement.h"

namespace csgsim::scan_line {

LineRetirement::LineRetirement(sc_core::sc_module_name name) : sc_core::sc_module(name) {}

void LineRetirement::begin(systemc::RunListener& listener, std::size_t line_count) {
  if (line_count > 0) frames_.push_back({&listener, line_count});
}

systemc::Keep LineRetirement::required_after(std::uint32_t segment, std::uint32_t index) {
  return frames_.back().listener->required_after(segment, index);
}

void LineRetirement::after_instruction(const systemc::Retired& retired, const systemc::PixelView& pixels) {
  frames_.front().listener->after_instruction(retired, pixels);
}

void LineRetirement::after_segment(std::uint32_t segment, const systemc::PixelView& pixels) {
  frames_.front().listener->after_segment(segment, pixels);
  if (--frames_.front().lines_left == 0) frames_.pop_front();
}

}  // namespace csgsim::scan_line
