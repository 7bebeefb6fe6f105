#include "hw/pixel_planes/datapath.h"

#include <utility>

namespace csgsim::pixel_planes {

Datapath::Datapath(array::PlaneShape shape, unsigned register_levels, std::optional<array::SteppedEvaluator> adders,
                   array::PixelArray pixels)
    : trees_(shape, register_levels),
      adders_(std::move(adders)),
      leaf_bits_(adders_ ? adders_->leaf_words() : 0),
      length_(trees_.latency()),
      delay_(length_),
      idle_(length_),
      pixels_(std::move(pixels)) {}

void Datapath::put(const ControlWord& word, const array::RootBits& bits) {
  control_ = word;
  carries_ = word != ControlWord{};
  if (std::exchange(roots_, bits) != bits && length_ == 0) clock_trees();
}

void Datapath::clock() {
  execute_word(at_pixels());
  if (length_ == 0) return;
  clock_trees();
  shift();
}

void Datapath::execute_word(const ControlWord& word) {
  last_executed_ = word;
  if (word.clears) {
    pixels_.select_pixels(word.clear.width, word.clear.height);
    pixels_.clear_memory(word.clear.address, word.clear.bits);
  } else if (has_leaf_bits_) {
    pixels_.step_with_planes(leaf_bits_, word.step);
  } else {
    pixels_.step(word.step, leaves_);
  }
  if (word.last) ++retired_;
}

void Datapath::clock_trees() {
  if (!adders_) {
    trees_.clock(roots_, leaves_);
  } else if (const array::Token token = adders_->clock(roots_, leaf_bits_); token.active()) {
    leaves_ = {.token = token};
    has_leaf_bits_ = true;
  }
}

/// Shifts the delay line; its last register is the output.
void Datapath::shift() {
  delay_[oldest_] = control_;
  oldest_ = oldest_ + 1 == delay_.size() ? 0 : oldest_ + 1;
  idle_ = carries_ ? 0 : idle_ + 1;
}

array::PixelProbe Datapath::probe(std::uint32_t x, std::uint32_t y) const {
  array::PixelProbe probe = pixels_.probe(x, y, leaves_);
  if (!has_leaf_bits_) return probe;
  const std::size_t plane = pixels_.shape().padded_words();
  probe.tree = 0;
  for (std::size_t bit = 0; bit < leaves_.token.bits; ++bit) {
    const std::span<const std::uint64_t> bits(&leaf_bits_[bit * plane], plane);
    probe.tree |= static_cast<std::uint32_t>(array::bit_of(bits, pixels_.shape(), x, y)) << bit;
  }
  return probe;
}

void Datapath::resume(const array::PixelArray& pixels, const array::StreamBit& tree) {
  pixels_ = pixels;
  leaves_ = tree;
  has_leaf_bits_ = false;
}

}  // namespace csgsim::pixel_planes
