#include "hw/array/pixel_array.h"

#include <algorithm>

#include "hw/array/kernels.h"

namespace csgsim::array {

namespace {

constexpr std::uint32_t byte_bits = 8;

/// Transposes 8 x 8 bits, one row per byte: bit c of row r becomes bit r of row c.
constexpr std::uint64_t transposed(std::uint64_t rows) {
  const auto swap = [&](unsigned distance, std::uint64_t upper) {
    const std::uint64_t differ = (rows ^ (rows >> distance)) & upper;
    rows ^= differ ^ (differ << distance);
  };
  swap(7, 0x00aa00aa00aa00aaU);
  swap(14, 0x0000cccc0000ccccU);
  swap(28, 0x00000000f0f0f0f0U);
  return rows;
}

}  // namespace

PixelArray::PixelArray(const isa::ArrayShape& shape, unsigned alu_bits)
    : shape_{shape.width, shape.height}, pixels_(shape_, {}, {alu_bits, shape.memory_bits}) {
  select_pixels(shape.width, shape.height);
}

PixelArray::PixelArray(std::span<const Place> pixels, std::uint32_t memory_bits, unsigned alu_bits)
    : shape_{static_cast<std::uint32_t>(pixels.size()), 1},
      places_(pixels.begin(), pixels.end()),
      pixels_(shape_, pixels, {alu_bits, memory_bits}) {
  const auto beyond = [&](std::uint32_t Place::*axis) {
    std::uint32_t most = 0;
    for (const Place& place : places_) most = std::max(most, place.*axis);
    return most + 1;
  };
  select_pixels(beyond(&Place::x), beyond(&Place::y));
}

void PixelArray::reset(std::uint32_t width, std::uint32_t height) {
  pixels_.reset();
  select_pixels(width, height);
}

void PixelArray::clear_memory(std::uint32_t address, std::uint32_t bits) { pixels_.clear_memory(address, bits); }

void PixelArray::select_pixels(std::uint32_t width, std::uint32_t height) {
  Words present(shape_.padded_words());
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const bool is_present = places_[i].x < width && places_[i].y < height;
    present[i / word_bits] |= std::uint64_t{is_present} << (i % word_bits);
  }
  for (std::uint32_t y = 0; y < height && places_.empty(); ++y) {
    for (std::uint32_t x = 0; x < width; x += word_bits) present[shape_.word_of(x, y)] = low_bits(width - x);
  }
  pixels_.select_pixels(present);
}

void PixelArray::step(const ArrayStep& step, const StreamBit& tree) { pixels_.push(step, tree); }

void PixelArray::step_with_planes(std::span<const std::uint64_t> tree, const ArrayStep& step) {
  pixels_.push_with_planes(tree, step);
}

bool PixelArray::any_enabled() const {
  const std::span<const std::uint64_t> plane = enable();
  return kernels::any_ones(plane.data(), plane.size());
}

std::uint64_t PixelArray::count_enabled() const {
  const std::span<const std::uint64_t> plane = enable();
  return kernels::count_ones(plane.data(), plane.size());
}

std::span<const std::uint64_t> PixelArray::enable() const {
  pixels_.settle();
  return pixels_.enable();
}

Words PixelArray::memory(std::uint32_t address) const {
  pixels_.settle_memory_bit(address);
  Words plane(shape_.padded_words());
  const unsigned bit = pixels_.bits().memory(address);
  for (std::size_t word = 0; word < plane.size(); ++word) plane[word] = pixels_.word(bit, word);
  return plane;
}

void PixelArray::read_row(std::uint32_t address, std::uint32_t row, std::span<std::uint64_t> words) const {
  pixels_.settle_memory_bit(address);
  const unsigned bit = pixels_.bits().memory(address);
  const std::size_t first = shape_.word_of(0, row);
  for (std::size_t i = 0; i < shape_.row_words(); ++i) words[i] = pixels_.word(bit, first + i);
}

void PixelArray::read_field(isa::Field field, std::uint32_t width, std::uint32_t height,
                            std::span<std::uint32_t> values) const {
  pixels_.settle();
  std::fill(values.begin(), values.end(), 0U);
  for (std::uint32_t bit = 0; bit < field.width; bit += byte_bits) {
    const auto base = static_cast<std::uint16_t>(field.base + bit);
    const auto bits = static_cast<std::uint16_t>(std::min(field.width - bit, byte_bits));
    for (std::uint32_t y = 0; y < height; ++y) {
      for (std::uint32_t x = 0; x < width; x += byte_bits) {
        std::uint64_t bytes = transposed(eight_pixels({base, bits}, x, y));
        std::uint32_t* const value = &values[std::size_t{y} * width + x];
        for (std::size_t i = 0; i < std::min(byte_bits, width - x); ++i, bytes >>= byte_bits)
          value[i] |= static_cast<std::uint32_t>(bytes & 0xffU) << bit;
      }
    }
  }
}

/// Byte r of the result: bit r of the field (at most 8 bits) at the 8 pixels from x on; x is a multiple of 8.
std::uint64_t PixelArray::eight_pixels(isa::Field field, std::uint32_t x, std::uint32_t y) const {
  std::uint64_t rows = 0;
  for (unsigned bit = 0; bit < field.width; ++bit) {
    const std::uint64_t word = pixels_.word(pixels_.bits().memory(field.base + bit), shape_.word_of(x, y));
    rows |= (word >> (x % word_bits) & 0xffU) << (bit * byte_bits);
  }
  return rows;
}

PixelProbe PixelArray::probe(std::uint32_t x, std::uint32_t y, const StreamBit& tree) const {
  pixels_.settle_registers();
  const auto is_set = [&](unsigned bit) {
    return (pixels_.word(bit, shape_.word_of(x, y)) >> (x % word_bits) & 1U) != 0;
  };
  std::uint32_t latch = 0;
  for (unsigned bit = 0; bit < pixels_.bits().alu_bits; ++bit)
    latch |= static_cast<std::uint32_t>(is_set(pixels_.bits().latch(bit))) << bit;
  return {.tree = tree.at(places_.empty() ? Place{x, y} : places_[x]),
          .carry = is_set(PixelBits::carry),
          .enable = bit_of(pixels_.enable(), shape_, x, y),
          .flag = is_set(PixelBits::flag),
          .latch = latch};
}

bool PixelArray::memory_bit(std::uint32_t address, std::uint32_t x, std::uint32_t y) const {
  pixels_.settle_memory_bit(address);
  return (pixels_.word(pixels_.bits().memory(address), shape_.word_of(x, y)) >> (x % word_bits) & 1U) != 0;
}

std::uint64_t PixelArray::value(isa::Field field, std::uint32_t x, std::uint32_t y) const {
  std::uint64_t value = 0;
  for (unsigned bit = 0; bit < field.width; ++bit) value |= std::uint64_t{memory_bit(field.base + bit, x, y)} << bit;
  return value;
}

}  // namespace csgsim::array
