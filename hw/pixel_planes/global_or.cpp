#include "hw/pixel_planes/global_or.h"

#include <algorithm>
#include <bit>

#include "hw/base/quotient.h"

namespace csgsim::pixel_planes {

GlobalOr::GlobalOr(sc_core::sc_module_name name, array::PlaneShape shape, std::uint32_t fan_in)
    : sc_core::sc_module(name), shape_(shape), fan_in_(fan_in) {
  std::size_t lines = fan_in == 0 ? 1 : std::size_t{shape.width} * shape.height;
  while (lines > 1) {
    lines = quotient_up(lines, fan_in);
    levels_.push_back({.pending = false, .bits = std::vector<bool>(lines)});
  }
  SC_HAS_PROCESS(GlobalOr);
  if (levels_.empty()) {
    SC_METHOD(reduce);
    dont_initialize();
    sensitive << question;
  } else {
    SC_METHOD(shift);
    dont_initialize();
    sensitive << clock.pos();
  }
}

void GlobalOr::set_test_results(std::vector<bool> results) { known_results_.emplace(results.begin(), results.end()); }

bool GlobalOr::any_enabled() {
  if (!known_results_) return enable->any_enabled();
  const bool found = known_results_->front();
  known_results_->pop_front();
  return found;
}

/// Called only for a global-OR test: no enable bit changes while the word of a test is at the pixels.
void GlobalOr::reduce() {
  const bool pending = question.read();
  answer.write({.valid = pending, .any_enabled = pending && any_enabled()});
}

/// Updates the last level first, so that each level reads the old value of the level before it. Registers without data
/// of a test keep their bits. Sleeps while no test is pending.
void GlobalOr::shift() {
  if (!clock.posedge()) return;
  for (std::size_t i = levels_.size() - 1; i > 0; --i) {
    levels_[i].pending = levels_[i - 1].pending;
    if (levels_[i].pending) reduce_level(levels_[i - 1], levels_[i]);
  }
  levels_.front().pending = question.read();
  if (levels_.front().pending) reduce_enable(levels_.front());
  const Level& last = levels_.back();
  answer.write({.valid = last.pending, .any_enabled = last.pending && last.bits.front()});
  const bool rests = std::none_of(levels_.begin(), levels_.end(), [](const Level& level) { return level.pending; });
  if (rests && !question.read()) next_trigger(question.value_changed_event());
}

/// Each gate of the first level combines consecutive pixels in row order.
void GlobalOr::reduce_enable(Level& level) {
  std::fill(level.bits.begin(), level.bits.end(), false);
  if (known_results_) {
    level.bits.front() = any_enabled();
    return;
  }
  const std::span<const std::uint64_t> bits = enable->pixels().enable();
  for (std::size_t y = 0; y < shape_.height; ++y) {
    for (std::size_t word = 0; word < shape_.row_words(); ++word) {
      const std::size_t first = y * shape_.width + word * array::word_bits;
      for (std::uint64_t rest = bits[y * shape_.row_words() + word]; rest != 0;) {
        const std::size_t gate = (first + static_cast<std::size_t>(std::countr_zero(rest))) / fan_in_;
        level.bits[gate] = true;
        const std::size_t next = (gate + 1) * fan_in_;  // the first pixel of the next gate
        rest = next - first < array::word_bits ? rest & ~array::low_bits(next - first) : 0;
      }
    }
  }
}

void GlobalOr::reduce_level(const Level& from, Level& to) const {
  std::fill(to.bits.begin(), to.bits.end(), false);
  for (std::size_t i = 0; i < from.bits.size(); ++i) {
    if (from.bits[i]) to.bits[i / fan_in_] = true;
  }
}

}  // namespace csgsim::pixel_planes
