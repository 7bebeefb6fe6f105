#include "sim/cycle/in_order.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "sim/cycle/segment_state.h"

namespace csgsim::cycle {

namespace {

/// The pixels after an instruction where no observer has said that it looks.
class Unread final : public systemc::PixelView {
 public:
  void read_field(isa::Field /*field*/, std::uint32_t /*width*/, std::uint32_t /*height*/,
                  std::span<std::uint32_t> /*values*/) const override {
    refuse();
  }
  void read_enable(std::uint32_t /*width*/, std::uint32_t /*height*/,
                   std::span<std::uint64_t> /*words*/) const override {
    refuse();
  }
  [[nodiscard]] std::unique_ptr<const PixelView> copy() const override { return std::make_unique<Unread>(); }

 private:
  [[noreturn]] static void refuse() {
    throw std::logic_error("an observer reads the state after an instruction without having said so");
  }
};

}  // namespace

InOrder::InOrder(const isa::Program& program, std::span<engine::Observer* const> observers)
    : program_(program), observers_(observers), held_(program.segments.size()) {}

bool InOrder::reads_after(const isa::Instruction& instruction) const {
  return std::any_of(observers_.begin(), observers_.end(),
                     [&](const engine::Observer* one) { return one->reads_after(instruction); });
}

void InOrder::after_instruction(const engine::Step& step, const systemc::PixelView& pixels) {
  const bool reads = reads_after(step.instruction);
  if (step.segment == due_) return tell(step, reads ? &pixels : nullptr);
  held_[step.segment].steps.push_back({step, reads ? pixels.copy() : nullptr});
}

void InOrder::after_segment(std::uint32_t segment, const systemc::PixelView& pixels) {
  if (segment != due_) {
    held_[segment].end = pixels.copy();
    return;
  }
  tell_end(segment, pixels);
  catch_up();
}

void InOrder::tell(const engine::Step& step, const systemc::PixelView* pixels) const {
  static const Unread unread;
  const SegmentState state(pixels == nullptr ? unread : *pixels, program_.segments[step.segment].region);
  for (engine::Observer* observer : observers_) observer->after_instruction(step, state);
}

void InOrder::tell_end(std::uint32_t segment, const systemc::PixelView& pixels) {
  const SegmentState state(pixels, program_.segments[segment].region);
  for (engine::Observer* observer : observers_) observer->after_segment(segment, state);
  ++due_;
}

/// Tells what has been kept of the segments whose turn has come, up to one that has not come to its end.
void InOrder::catch_up() {
  while (due_ < held_.size()) {
    const Held segment = std::exchange(held_[due_], {});
    for (const HeldStep& one : segment.steps) tell(one.step, one.pixels.get());
    if (!segment.end) return;
    tell_end(due_, *segment.end);
  }
}

}  // namespace csgsim::cycle
