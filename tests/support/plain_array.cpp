#include "tests/support/plain_array.h"

#include <algorithm>

namespace csgsim::test {

using array::AluFunction;

namespace {

bool majority(bool a, bool b, bool c) { return (a ? 1 : 0) + (b ? 1 : 0) + (c ? 1 : 0) >= 2; }

}  // namespace

PixelState next_state(AluFunction function, bool constant, PixelState state) {
  const auto less = [&state](bool carry_in) {
    state.carry = majority(state.x, !state.y, carry_in);
    state.enable = state.enable && !state.carry;
  };
  const auto write = [&state](bool value) { state.memory = state.enable ? value : state.memory; };
  const auto sum = [&](bool x, bool carry_in) {
    write((x != state.y) != carry_in);
    state.carry = majority(x, state.y, carry_in);
  };
  const auto difference = [&](bool carry_in) {
    write((state.x != !state.y) != carry_in);
    state.carry = majority(state.x, !state.y, carry_in);
  };
  const auto sign = [&state] { state.carry = majority(!state.x, false, state.carry); };
  switch (function) {
    case AluFunction::idle:
    case AluFunction::answer: break;
    case AluFunction::latch_x: state.latch = state.x; break;
    case AluFunction::enable_all: state.enable = state.present; break;
    case AluFunction::enable_invert: state.enable = state.present && !state.enable; break;
    case AluFunction::enable_load: state.enable = state.x; break;
    case AluFunction::enable_and: state.enable = state.enable && state.x; break;
    case AluFunction::enable_and_not: state.enable = state.enable && !state.x; break;
    case AluFunction::enable_or: state.enable = state.enable || state.x; break;
    case AluFunction::enable_xor: state.enable = state.enable != state.x; break;
    case AluFunction::enable_equal: state.enable = state.enable && state.x == state.y; break;
    case AluFunction::compare_from_0: state.carry = majority(state.x, !state.y, false); break;
    case AluFunction::compare_from_1: state.carry = majority(state.x, !state.y, true); break;
    case AluFunction::compare: state.carry = majority(state.x, !state.y, state.carry); break;
    case AluFunction::compare_with_0: state.carry = majority(state.x, true, state.carry); break;
    case AluFunction::less_from_0: less(false); break;
    case AluFunction::less_from_1: less(true); break;
    case AluFunction::less: less(state.carry); break;
    case AluFunction::sign_enable:
      sign();
      state.enable = state.enable && state.carry;
      break;
    case AluFunction::sign_enable_not:
      sign();
      state.enable = state.enable && !state.carry;
      break;
    case AluFunction::sign_select:
      sign();
      state.carry = state.enable && state.carry;
      break;
    case AluFunction::sign_select_not:
      sign();
      state.carry = state.enable && !state.carry;
      break;
    case AluFunction::enable_fits: state.enable = state.enable && !(state.carry && state.x); break;
    case AluFunction::store_x: write(state.x); break;
    case AluFunction::store_x_selected:
      if (state.carry) write(state.x);
      break;
    case AluFunction::store_not_x: write(!state.x); break;
    case AluFunction::store_constant: write(constant); break;
    case AluFunction::store_xor_constant: write(state.x != constant); break;
    case AluFunction::store_and: write(state.x && state.y); break;
    case AluFunction::store_or: write(state.x || state.y); break;
    case AluFunction::store_xor: write(state.x != state.y); break;
    case AluFunction::store_and_not: write(state.x && !state.y); break;
    case AluFunction::sum_from_0: sum(state.x, false); break;
    case AluFunction::sum: sum(state.x, state.carry); break;
    case AluFunction::sum_with_0: sum(false, state.carry); break;
    case AluFunction::sum_with_1_from_0: sum(true, false); break;
    case AluFunction::sum_with_1: sum(true, state.carry); break;
    case AluFunction::difference_from_1: difference(true); break;
    case AluFunction::difference: difference(state.carry); break;
    case AluFunction::root_first:
      state.flag = !state.carry;
      write(state.carry);
      break;
    case AluFunction::root_bit: sum(state.x != !state.flag, state.carry); break;
    case AluFunction::root_sign:
      state.flag = (state.y != !state.flag) != state.carry;
      write(!state.flag);
      break;
    case AluFunction::store_enable: state.memory = state.enable; break;
  }
  return state;
}

PlainArray::PlainArray(array::PlaneShape shape, std::uint32_t memory_bits, unsigned alu_bits)
    : shape_(shape),
      pixels_(std::size_t{shape.width} * shape.height,
              {.latch = std::vector<bool>(alu_bits), .memory = std::vector<bool>(memory_bits)}) {}

void PlainArray::clear_memory(std::uint32_t address, std::uint32_t bits) {
  for (Pixel& pixel : pixels_) std::fill_n(pixel.memory.begin() + address, bits, false);
}

void PlainArray::select_pixels(std::uint32_t width, std::uint32_t height) {
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
void PlainArray::execute_step(const array::ArrayStep& step, std::uint32_t leaves, Pixel& pixel) {
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
    state = next_state(function, constant, state);
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
    execute_step(step, leaves, pixels_[i]);
  }
}

}  // namespace csgsim::test
