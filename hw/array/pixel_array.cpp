#include "hw/array/pixel_array.h"

#include <algorithm>

#include "hw/array/kernels.h"

namespace csgsim::array {

PixelArray::PixelArray(const isa::ArrayShape& shape, unsigned alu_bits)
    : shape_{shape.width, shape.height},
      memory_(shape.memory_bits, Words(shape_.padded_words())),
      enable_(shape_.padded_words()),
      carry_(shape_.padded_words()),
      latch_(alu_bits, Words(shape_.padded_words())),
      present_(shape_.padded_words()) {
  reset(shape.width, shape.height);
}

void PixelArray::reset(std::uint32_t width, std::uint32_t height) {
  clear_memory(0, memory_bits());
  select(width, height);
}

void PixelArray::clear_memory(std::uint32_t address, std::uint32_t bits) {
  for (std::uint32_t bit = address; bit < address + bits; ++bit) std::fill(memory_[bit].begin(), memory_[bit].end(), 0);
}

void PixelArray::select(std::uint32_t width, std::uint32_t height) {
  for (Words& plane : latch_) std::fill(plane.begin(), plane.end(), 0);
  for (Words* plane : {&enable_, &carry_, &present_}) std::fill(plane->begin(), plane->end(), 0);
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; x += word_bits) present_[shape_.word_of(x, y)] = low_bits(width - x);
  }
}

void PixelArray::step(const ArrayStep& step, std::span<const std::uint64_t> tree) {
  if (step.function == AluFunction::idle || step.function == AluFunction::answer) return;
  for (unsigned bit = 0; bit < step.bits; ++bit) bit_step(step, bit, tree);
}

void PixelArray::bit_step(const ArrayStep& step, unsigned bit, std::span<const std::uint64_t> tree) {
  const AluFunction function = function_of_bit(step, bit);
  const AluInfo& row = info(function);
  const auto operand_x = [&]() -> const std::uint64_t* {
    if (!row.reads_x) return nullptr;
    switch (step.source) {
      case OperandSource::tree: return tree.data();
      case OperandSource::latch: return latch_[bit].data();
      case OperandSource::memory: return memory_[step.x + bit].data();
    }
    return nullptr;
  };
  kernels::alu_step(function, {.x = operand_x(),
                               .y = row.reads_y ? memory_[step.y + bit].data() : nullptr,
                               .present = present_.data(),
                               .enable = enable_.data(),
                               .carry = carry_.data(),
                               .latch = latch_[bit].data(),
                               .write = row.writes ? memory_[step.write + bit].data() : nullptr,
                               .constant = (step.constant >> bit & 1U) != 0,
                               .words = shape_.padded_words()});
}

bool PixelArray::any_enabled() const { return kernels::any_ones(enable_.data(), enable_.size()); }

std::uint64_t PixelArray::count_enabled() const { return kernels::count_ones(enable_.data(), enable_.size()); }

void PixelArray::read_field(isa::Field field, std::uint32_t width, std::uint32_t height,
                            std::span<std::uint32_t> values) const {
  std::fill(values.begin(), values.end(), 0U);
  for (std::uint32_t bit = 0; bit < field.width; ++bit) {
    const Words& plane = memory_[field.base + bit];
    for (std::uint32_t y = 0; y < height; ++y) {
      for (std::uint32_t x = 0; x < width; ++x) {
        const auto value = static_cast<std::uint32_t>(plane[shape_.word_of(x, y)] >> (x % word_bits)) & 1U;
        values[std::size_t{y} * width + x] |= value << bit;
      }
    }
  }
}

PixelProbe PixelArray::probe(std::uint32_t x, std::uint32_t y, std::span<const std::uint64_t> tree) const {
  std::uint32_t latch = 0;
  for (unsigned bit = 0; bit < latch_.size(); ++bit) {
    latch |= static_cast<std::uint32_t>(bit_of(latch_[bit], shape_, x, y)) << bit;
  }
  return {.tree = bit_of(tree, shape_, x, y),
          .carry = bit_of(carry_, shape_, x, y),
          .enable = bit_of(enable_, shape_, x, y),
          .latch = latch};
}

}  // namespace csgsim::array
