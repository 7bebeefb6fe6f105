#include "sim/cycle/in_order.h"

#include <algorithm>
#include <utility>

#include "sim/cycle/segment_state.h"

namespace csgsim::cycle {

ProgramOrderBuffer::ProgramOrderBuffer(const isa::Program& program, std::span<engine::Observer* const> observers)
    : program_(program), observers_(observers), held_(program.segments.size()) {}

bool ProgramOrderBuffer::reads_after(const isa::Instruction& instruction) const {
  return std::any_of(observers_.begin(), observers_.end(),
                     [&](const engine::Observer* one) { return one->reads_after(instruction); });
}

void ProgramOrderBuffer::after_instruction(const engine::Step& step, const systemc::PixelView& pixels) {
  const bool reads = reads_after(step.instruction);
  if (step.segment == due_) return notify(step, reads ? &pixels : nullptr);
  held_[step.segment].steps.push_back({step, reads ? pixels.copy() : nullptr});
}

void ProgramOrderBuffer::after_segment(std::uint32_t segment, const systemc::PixelView& pixels) {
  if (segment != due_) {
    held_[segment].end = pixels.copy();
    return;
  }
  notify_segment_end(segment, pixels);
  catch_up();
}

void ProgramOrderBuffer::notify(const engine::Step& step, const systemc::PixelView* pixels) const {
  const SegmentState state(pixels, program_.segments[step.segment].region);
  for (engine::Observer* observer : observers_) observer->after_instruction(step, state);
}

void ProgramOrderBuffer::notify_segment_end(std::uint32_t segment, const systemc::PixelView& pixels) {
  const SegmentState state(&pixels, program_.segments[segment].region);
  for (engine::Observer* observer : observers_) observer->after_segment(segment, state);
  ++due_;
}

/// Notifies observers of the buffered segments that are due, up to the first unfinished one.
void ProgramOrderBuffer::catch_up() {
  while (due_ < held_.size()) {
    const BufferedSegment segment = std::exchange(held_[due_], {});
    for (const BufferedStep& one : segment.steps) notify(one.step, one.pixels.get());
    if (!segment.end) return;
    notify_segment_end(due_, *segment.end);
  }
}

}  // namespace csgsim::cycle
