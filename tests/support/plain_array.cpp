#include "tests/support/plain_array.h"

#include <algorithm>

namespace csgsim::test {

using array::AluFunction;

namespace {

bool majority(bool a, bool b, bool c) { return (a ? 1 : 0) + (b ? 1 : 0) + (c ? 1 : 0) >= 2; }

}  // namespace

PixelState after(AluFunction function, bool constant, PixelState p) {
  const auto less = [&p](bool carry_in) {
    p.carry = majority(p.x, !p.y, carry_in);
    p.enable = p.enable && !p.carry;
  };
  const auto write = [&p](bool value) { p.memory = p.enable ? value : p.memory; };
  const auto sum = [&](bool x, bool carry_in) {
    write((x != p.y) != carry_in);
    p.carry = majority(x, p.y, carry_in);
  };
  const auto difference = [&](bool carry_in) {
    write((p.x != !p.y) != carry_in);
    p.carry = majority(p.x, !p.y, carry_in);
  };
  const auto sign = [&p] { p.carry = majority(!p.x, false, p.carry); };
  switch (function) {
    case AluFunction::idle:
    case AluFunction::answer: break;
    case AluFunction::latch_x: p.latch = p.x; break;
    case AluFunction::enable_all: p.enable = p.present; break;
    case AluFunction::enable_invert: p.enable = p.present && !p.enable; break;
    case AluFunction::enable_load: p.enable = p.x; break;
    case AluFunction::enable_and: p.enable = p.enable && p.x; break;
    case AluFunction::enable_and_not: p.enable = p.enable && !p.x; break;
    case AluFunction::enable_or: p.enable = p.enable || p.x; break;
    case AluFunction::enable_xor: p.enable = p.enable != p.x; break;
    case AluFunction::enable_equal: p.enable = p.enable && p.x == p.y; break;
    case AluFunction::compare_from_0: p.carry = majority(p.x, !p.y, false); break;
    case AluFunction::compare_from_1: p.carry = majority(p.x, !p.y, true); break;
    case AluFunction::compare: p.carry = majority(p.x, !p.y, p.carry); break;
    case AluFunction::compare_with_0: p.carry = majority(p.x, true, p.carry); break;
    case AluFunction::less_from_0: less(false); break;
    case AluFunction::less_from_1: less(true); break;
    case AluFunction::less: less(p.carry); break;
    case AluFunction::sign_enable:
      sign();
      p.enable = p.enable && p.carry;
      break;
    case AluFunction::sign_enable_not:
      sign();
      p.enable = p.enable && !p.carry;
      break;
    case AluFunction::sign_select:
      sign();
      p.carry = p.enable && p.carry;
      break;
    case AluFunction::sign_select_not:
      sign();
      p.carry = p.enable && !p.carry;
      break;
    case AluFunction::enable_fits: p.enable = p.enable && !(p.carry && p.x); break;
    case AluFunction::store_x: write(p.x); break;
    case AluFunction::store_x_selected:
      if (p.carry) write(p.x);
      break;
    case AluFunction::store_not_x: write(!p.x); break;
    case AluFunction::store_constant: write(constant); break;
    case AluFunction::store_xor_constant: write(p.x != constant); break;
    case AluFunction::store_and: write(p.x && p.y); break;
    case AluFunction::store_or: write(p.x || p.y); break;
    case AluFunction::store_xor: write(p.x != p.y); break;
    case AluFunction::store_and_not: write(p.x && !p.y); break;
    case AluFunction::sum_from_0: sum(p.x, false); break;
    case AluFunction::sum: sum(p.x, p.carry); break;
    case AluFunction::sum_with_0: sum(false, p.carry); break;
    case AluFunction::sum_with_1_from_0: sum(true, false); break;
    case AluFunction::sum_with_1: sum(true, p.carry); break;
    case AluFunction::difference_from_1: difference(true); break;
    case AluFunction::difference: difference(p.carry); break;
    case AluFunction::root_first:
      p.flag = !p.carry;
      write(p.carry);
      break;
    case AluFunction::root_bit: sum(p.x != !p.flag, p.carry); break;
    case AluFunction::root_sign:
      p.flag = (p.y != !p.flag) != p.carry;
      write(!p.flag);
      break;
    case AluFunction::store_enable: p.memory = p.enable; break;
  }
  return p;
}

PlainArray::PlainArray(array::PlaneShape shape, std::uint32_t memory_bits, unsigned alu_bits)
    : shape_(shape),
      pixels_(std::size_t{shape.width} * shape.height,
              {.latch = std::vector<bool>(alu_bits), .memory = std::vector<bool>(memory_bits)}) {}

void PlainArray::clear_memory(std::uint32_t address, std::uint32_t bits) {
  for (Pixel& pixel : pixels_) std::fill_n(pixel.memory.begin() + address, bits, false);
}

void PlainArray::select(std::uint32_t width, std::uint32_t height) {
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    Pixel& pixel = pixels_[i];
    pixel.present = i % shape_.width < width && i / shape_.width < height;
    pixel.enable = false;
    pixel.carry = false;
    pixel.flag = false;
    std::fill(pixel.latch.begin(), pixel.latch.end(), false);
  }
}

/// Tree bits from `first` on go, one bit each, to the function, then to the part beyond the field, then to the sign.
void PlainArray::carry_out(const array::ArrayStep& step, std::uint32_t leaves, Pixel& pixel) {
  const auto work = [&](AluFunction function, bool constant, bool x, bool y, bool latch,
                        std::vector<bool>::size_type to) {
    PixelState state{.x = x,
                     .y = y,
                     .present = pixel.present,
                     .enable = pixel.enable,
                     .carry = pixel.carry,
                     .latch = latch,
                     .flag = pixel.flag};
    const bool writes = array::info(function).writes;
    if (writes) state.memory = pixel.memory[to];
    state = after(function, constant, state);
    pixel.enable = state.enable;
    pixel.carry = state.carry;
    pixel.flag = state.flag;
    if (writes) pixel.memory[to] = state.memory;
    return state.latch;
  };
  const auto leaf = [&](unsigned bit) { return (leaves >> (step.first + bit) & 1U) != 0; };
  for (unsigned bit = 0; bit < step.bits; ++bit) {
    const AluFunction function = array::function_of_bit(step, bit);
    const array::AluInfo& row = array::info(function);
    bool x = false;
    if (row.reads_x && step.source == array::OperandSource::tree) x = leaf(bit);
    if (row.reads_x && step.source == array::OperandSource::latch) x = pixel.latch[bit];
    if (row.reads_x && step.source == array::OperandSource::memory) x = pixel.memory[step.x + bit];
    const bool y = row.reads_y && pixel.memory[step.y + bit];
    pixel.latch[bit] = work(function, (step.constant >> bit & 1U) != 0, x, y, pixel.latch[bit], step.write + bit);
  }
  for (unsigned bit = step.bits; bit < step.bits + step.beyond_bits; ++bit)
    work(step.beyond, false, leaf(bit), false, false, 0);
  if (step.sign != AluFunction::idle) work(step.sign, false, leaf(step.bits + step.beyond_bits), false, false, 0);
}

void PlainArray::step(const array::ArrayStep& step, const array::StreamBit& tree) {
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    const array::Place place{static_cast<std::uint32_t>(i % shape_.width),
                             static_cast<std::uint32_t>(i / shape_.width)};
    std::uint32_t leaves = 0;
    for (unsigned bit = 0; bit < tree.token.bits && tree.token.active(); ++bit) {
      const auto number = static_cast<unsigned>(tree.token.bit) + bit;
      leaves |= static_cast<std::uint32_t>(array::value_at(tree, place.x, place.y) >> number & 1U) << bit;
    }
    carry_out(step, leaves, pixels_[i]);
  }
}

}  // namespace csgsim::test
