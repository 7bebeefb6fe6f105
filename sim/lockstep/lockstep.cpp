#include "sim/lockstep/lockstep.h"

#include <algorithm>
#include <utility>

namespace csgsim::lockstep {

Lockstep::Lockstep(const isa::Program& a, const isa::Program& b, engine::Run& b_run, LockstepSettings settings,
                   std::span<engine::Observer* const> b_observers)
    : b_program_(b),
      a_numbers_(a),
      b_numbers_(b),
      b_(b_run),
      settings_(settings),
      comparison_(a, std::min(a.shape.memory_bits, b.shape.memory_bits)),
      b_observers_(b_observers.begin(), b_observers.end()) {
  b_observers_.push_back(&last_);
}

void Lockstep::record_divergence(engine::Place place, std::optional<PixelDifference> pixel,
                                 std::optional<TwoValues> otherwise) {
  divergence_ = Divergence{place, std::move(pixel), std::move(otherwise)};
  compares_ = false;
}

std::optional<TwoValues> Lockstep::step_difference(const engine::Step& step) const {
  if (settings_.clocks && last_.clocks != step.clocks) return TwoValues{"clocks", step.clocks, last_.clocks};
  if (last_.enabled_pixels != step.enabled_pixels)
    return TwoValues{"enabled pixels", step.enabled_pixels, last_.enabled_pixels};
  return std::nullopt;
}

void Lockstep::after_instruction(const engine::Step& step, const engine::PixelState& state) {
  if (!compares_) return;
  const engine::Place place{step.segment, step.index};
  const std::uint64_t number = a_numbers_.of(place);
  if (number >= settings_.end) {
    compares_ = false;
    return;
  }
  const std::uint64_t next = b_numbers_.of(b_.place());
  if (next == number && !b_.is_finished()) b_.advance(number + 1, b_observers_);
  if (next != number || last_.place != place)
    return record_divergence(place, {}, TwoValues{"instruction", number, next});
  if (number < settings_.begin) return;
  const bool is_whole = (number + 1) % settings_.whole_every == 0;
  std::optional<PixelDifference> pixel =
      is_whole ? comparison_.compare_all(state, b_) : comparison_.compare_written(step.instruction, state, b_);
  if (!pixel && !is_whole) {
    const isa::Instruction& other = b_program_.segments[step.segment].instructions[step.index];
    if (other.fields != step.instruction.fields) pixel = comparison_.compare_written(other, state, b_);
  }
  if (pixel) return record_divergence(place, std::move(pixel), {});
  if (std::optional<TwoValues> otherwise = step_difference(step))
    return record_divergence(place, {}, std::move(otherwise));
  ++compared_;
  if (is_whole) whole_until_ = number + 1;
}

void Lockstep::after_segment(std::uint32_t segment, const engine::PixelState& state) {
  if (!compares_ || a_numbers_.first(segment + 1) > settings_.end) return;
  // B passes segments without instructions when it continues: there is nothing to compare.
  if (a_numbers_.first(segment) == a_numbers_.first(segment + 1)) return;
  const engine::Place last{segment,
                           static_cast<std::uint32_t>(a_numbers_.first(segment + 1) - a_numbers_.first(segment) - 1)};
  if (b_.place() != engine::Place{segment, last.index + 1})
    return record_divergence(last, {},
                             TwoValues{"instruction", a_numbers_.first(segment + 1), b_numbers_.of(b_.place())});
  if (std::optional<PixelDifference> pixel = comparison_.compare_all(state, b_))
    return record_divergence(last, std::move(pixel), {});
  whole_until_ = a_numbers_.first(segment + 1);
}

void Lockstep::finish() { b_.advance(engine::Run::end, b_observers_); }

}  // namespace csgsim::lockstep
