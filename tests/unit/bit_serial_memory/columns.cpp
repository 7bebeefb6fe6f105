#include "tests/unit/bit_serial_memory/columns.h"

#include <algorithm>

namespace csgsim::testing {

using bit_serial_memory::Design;
using bit_serial_memory::Expressions;
using bit_serial_memory::Latch;
using bit_serial_memory::MicroDesign;
using bit_serial_memory::Row;
using bit_serial_memory::RowWords;

Columns::Columns(isa::ArrayShape shape, const MicroDesign& design)
    : shape_(shape),
      design_(design),
      map_(shape.memory_bits, shape.width, shape.height),
      subarray_(map_, shape.width * shape.height) {
  for (unsigned i = 0; i < map_.x_bits; ++i)
    subarray_.set_row(map_.x(i), words_of([&](std::uint32_t x, std::uint32_t /*y*/) { return (x >> i & 1U) != 0; }));
  for (unsigned i = 0; i < map_.y_bits; ++i)
    subarray_.set_row(map_.y(i), words_of([&](std::uint32_t /*x*/, std::uint32_t y) { return (y >> i & 1U) != 0; }));
}

template <class BitOf>
RowWords Columns::words_of(const BitOf& bit_of) const {
  RowWords words(subarray_.words());
  for (std::uint32_t y = 0; y < shape_.height; ++y) {
    for (std::uint32_t x = 0; x < shape_.width; ++x) {
      const std::uint32_t column = y * shape_.width + x;
      if (bit_of(x, y)) words[column / 64] |= std::uint64_t{1} << column % 64;
    }
  }
  return words;
}

void Columns::set(const reference::ReferenceArray& pixels) {
  for (std::uint32_t bit = 0; bit < shape_.memory_bits; ++bit) {
    subarray_.set_row(static_cast<Row>(bit), words_of([&](std::uint32_t x, std::uint32_t y) {
                        return pixels.read({static_cast<std::uint16_t>(bit), 1}, x, y) != 0;
                      }));
  }
  subarray_.set_row(map_.enable(), words_of([&](std::uint32_t x, std::uint32_t y) { return pixels.is_enabled(x, y); }));
  if (!design_.enable_latch) return;
  subarray_.execute({.op = bit_serial_memory::RowOp::latch, .from = bit_serial_memory::WordLines(map_.enable())}, {});
}

void Columns::execute(const bit_serial_memory::RowCommands& commands, const isa::Linear& linear) {
  const auto leaves = [&](unsigned bit, std::span<std::uint64_t> words) {
    std::ranges::copy(words_of([&](std::uint32_t x, std::uint32_t y) {
                        const std::uint64_t sum = static_cast<std::uint64_t>(linear.a) * x +
                                                  static_cast<std::uint64_t>(linear.b) * y +
                                                  static_cast<std::uint64_t>(linear.c);
                        return (sum >> bit & 1U) != 0;
                      }),
                      words.begin());
  };
  for (const bit_serial_memory::RowCommand& command : commands) subarray_.execute(command, leaves);
}

bool Columns::bit(std::span<const std::uint64_t> words, std::uint32_t x, std::uint32_t y) const {
  const std::uint32_t column = y * shape_.width + x;
  return (words[column / 64] >> column % 64 & 1U) != 0;
}

bool Columns::memory_bit(std::uint32_t number, std::uint32_t x, std::uint32_t y) const {
  return bit(subarray_.row(static_cast<Row>(number)), x, y);
}

bool Columns::enabled(std::uint32_t x, std::uint32_t y) const {
  const bool in_latch = design_.design == Design::latches && design_.enable_latch;
  return bit(in_latch ? subarray_.latch(Latch::enable) : subarray_.row(map_.enable()), x, y);
}

std::vector<MicroDesign> all_designs() {
  std::vector<MicroDesign> designs;
  for (const Design design : {Design::and_or_not, Design::majority, Design::latches}) {
    for (const Expressions expressions : {Expressions::rows, Expressions::planes, Expressions::trees}) {
      for (const bool latch : {false, true}) designs.push_back({design, expressions, latch, latch});
    }
  }
  return designs;
}

std::size_t count_of(bit_serial_memory::RowOp op, const bit_serial_memory::RowCommands& commands) {
  return static_cast<std::size_t>(std::ranges::count(commands, op, &bit_serial_memory::RowCommand::op));
}

}  // namespace csgsim::testing
