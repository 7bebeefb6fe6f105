#include "hw/pixel_planes/pixel_processors.h"

#include <utility>

namespace csgsim::pixel_planes {

PixelProcessors::PixelProcessors(sc_core::sc_module_name name, const isa::ArrayShape& shape, unsigned alu_bits,
                                 const systemc::Foretold* foretold)
    : systemc::ClockedModule(name),
      pixels_(foretold == nullptr ? array::PixelArray(shape, alu_bits)
                                  : array::PixelArray(foretold->pixels, shape.memory_bits, alu_bits)),
      row_(pixels_.shape().row_words()) {
  if (foretold != nullptr) foretold_.emplace(array::PlaneShape{shape.width, shape.height}, foretold->picture);
  refresh.bind(*this);
  enable_lines.bind(*this);
}

/// Sleeps while there is nothing to do.
void PixelProcessors::on_clock() {
  if (!clock.posedge()) return;
  const ControlWord& word = control.read();
  if (word.clears) {
    pixels_.select(word.clear.width, word.clear.height);
    pixels_.clear_memory(word.clear.address, word.clear.bits);
  } else if (!word.refreshes) {
    step(word.step);
  }
  carried_out_ = word;
  if (word.last) retired.write(++retired_count_);
  if (word == ControlWord{}) next_trigger(control.value_changed_event());
}

void PixelProcessors::step(const array::ArrayStep& step) {
  const TreeWord& word = tree.read();
  if (word.pixels == nullptr) {
    pixels_.step(step, word.bit);
  } else {
    pixels_.step_with(*word.pixels, step);
  }
}

array::PixelProbe PixelProcessors::probe(std::uint32_t x, std::uint32_t y) const {
  const TreeWord& word = tree.read();
  array::PixelProbe probe = pixels_.probe(x, y, word.bit);
  if (word.pixels == nullptr) return probe;
  const std::size_t plane = pixels_.shape().padded_words();
  probe.tree = 0;
  for (std::size_t bit = 0; bit < word.bit.token.bits; ++bit) {
    const std::span<const std::uint64_t> bits(&(*word.pixels)[bit * plane], plane);
    probe.tree |= static_cast<std::uint32_t>(array::bit_of(bits, pixels_.shape(), x, y)) << bit;
  }
  return probe;
}

void PixelProcessors::resume(const array::PixelArray& pixels, isa::Field shown) {
  pixels_ = pixels;
  if (foretold_) foretold_->show(shown);
}

std::span<const std::uint64_t> PixelProcessors::Picture::row(std::uint32_t address, std::uint32_t row) const {
  row_.assign(shape_.row_words(), 0);
  const std::uint32_t bit = address - field_.base;
  for (std::uint32_t x = 0; x < shape_.width; ++x) {
    const std::uint64_t colour = colours_[std::size_t{row} * shape_.width + x];
    row_[x / array::word_bits] |= (colour >> bit & 1U) << (x % array::word_bits);
  }
  return row_;
}

}  // namespace csgsim::pixel_planes
