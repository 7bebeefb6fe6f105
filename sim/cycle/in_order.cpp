#include "sim/cycle/in_order.h"

#include <algorithm>

#include "sim/cycle/array_state.h"

namespace csgsim::sim {

InOrder::InOrder(const isa::Program& program, const isa::ArrayShape& array, std::span<Observer* const> observers)
    : program_(program), observers_(observers), blank_(array, 1) {}

void InOrder::after_instruction(const Step& step, const array::PixelArray& pixels) {
  if (step.segment == due_) return tell(step, pixels);
  held_[step.segment].steps.push_back(
      {step, read_after(step.instruction) ? std::make_shared<const array::PixelArray>(pixels) : nullptr});
}

void InOrder::after_segment(std::uint32_t segment, const array::PixelArray& pixels) {
  if (segment != due_) {
    held_[segment].end = std::make_shared<const array::PixelArray>(pixels);
    return;
  }
  tell_end(segment, pixels);
  ++due_;
  proceed();
}

bool InOrder::read_after(const isa::Instruction& instruction) const {
  return std::any_of(observers_.begin(), observers_.end(),
                     [&](const Observer* one) { return one->reads_after(instruction); });
}

void InOrder::tell(const Step& step, const array::PixelArray& pixels) const {
  const ArrayState state(pixels, program_.segments[step.segment].region);
  for (Observer* observer : observers_) observer->after_instruction(step, state);
}

void InOrder::tell_end(std::uint32_t segment, const array::PixelArray& pixels) const {
  const ArrayState state(pixels, program_.segments[segment].region);
  for (Observer* observer : observers_) observer->after_segment(segment, state);
}

/// Tells what has been kept of the segments whose turn has come.
void InOrder::proceed() {
  for (; due_ < program_.segments.size(); ++due_) {
    if (program_.segments[due_].instructions.empty()) {
      tell_end(due_, blank_);
      continue;
    }
    const auto held = held_.find(due_);
    if (held == held_.end()) return;
    const Held segment = std::move(held->second);
    held_.erase(held);
    for (const HeldStep& one : segment.steps) tell(one.step, one.pixels ? *one.pixels : blank_);
    if (!segment.end) return;
    tell_end(due_, *segment.end);
  }
}

}  // namespace csgsim::sim
