#include "sim/cycle/relay.h"

#include <algorithm>
#include <optional>
#include <tuple>

#include "sim/cycle/overflow.h"

namespace csgsim::cycle {

namespace {

bool next_can_overflow(const isa::Segment& segment, std::uint32_t index) {
  const std::optional<Expression> next = find_expression(segment, index + 1);
  return next && can_overflow(*next, segment.region);
}

}  // namespace

systemc::Keep Relay::required_after(std::uint32_t segment, std::uint32_t index) {
  const isa::Segment& drawn = program_.segments[segment];
  if (in_order_.reads_after(drawn.instructions[index])) return systemc::Keep::all;
  return next_can_overflow(drawn, index) ? systemc::Keep::enable : systemc::Keep::nothing;
}

void Relay::after_instruction(const systemc::Retired& retired, const systemc::PixelView& pixels) {
  if (retired.skipped > 0) skips_.push_back({retired.segment, retired.index});
  count_overflows_of_next(retired, pixels);
  in_order_.after_instruction({.segment = retired.segment,
                               .index = retired.index,
                               .instruction = program_.segments[retired.segment].instructions[retired.index],
                               .clocks = retired.clocks,
                               .enabled_pixels = retired.enabled_pixels,
                               .at_pixels = retired.at_pixels},
                              pixels);
}

void Relay::after_segment(std::uint32_t segment, const systemc::PixelView& pixels) {
  in_order_.after_segment(segment, pixels);
}

std::vector<machines::Skip> Relay::skips() const {
  std::vector<machines::Skip> sorted = skips_;
  std::ranges::sort(sorted, {}, [](const machines::Skip& one) { return std::tuple(one.segment, one.index); });
  return sorted;
}

/// No pixel is enabled at the start of a segment, nor where instructions are skipped.
void Relay::count_overflows_of_next(const systemc::Retired& retired, const systemc::PixelView& pixels) {
  const isa::Segment& segment = program_.segments[retired.segment];
  const std::optional<Expression> next = find_expression(segment, retired.index + 1);
  if (retired.skipped > 0 || !next || !can_overflow(*next, segment.region)) return;
  const std::size_t row_words = (segment.region.width + 63U) / 64U;
  enable_.resize(row_words * segment.region.height);
  pixels.read_enable(segment.region.width, segment.region.height, enable_);
  overflows_ += count_overflows(*next, segment.region, enable_, row_words);
}

}  // namespace csgsim::cycle
