#include "sim/reference/reference_array.h"

#include <algorithm>
#include <bit>
#include <functional>
#include <numeric>

#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"

namespace csgsim::reference {

namespace {

__extension__ using Wide = __int128;

/// The exact value of A*x + B*y + C.
Wide exact_sum(const isa::Linear& linear, std::uint32_t x, std::uint32_t y) {
  return static_cast<Wide>(linear.a) * x + static_cast<Wide>(linear.b) * y + linear.c;
}

/// The exact value of A*x*x + B*x*y + C*y*y.
Wide exact_squares(const isa::Linear& squares, std::uint32_t x, std::uint32_t y) {
  return static_cast<Wide>(squares.a) * x * x + static_cast<Wide>(squares.b) * x * y +
         static_cast<Wide>(squares.c) * y * y;
}

/// The greatest integer whose square is at most `square`, which must be below 2^60.
std::uint64_t integer_root(std::uint64_t square) {
  std::uint64_t least = 0;
  std::uint64_t beyond = std::uint64_t{1} << 30U;
  while (beyond - least > 1) {
    const std::uint64_t middle = (least + beyond) / 2;
    (middle * middle <= square ? least : beyond) = middle;
  }
  return least;
}

/// The result of the instruction `root` for a field of 2w + 1 bits.
std::uint64_t make_rooted_tree(std::uint64_t field, unsigned w) {
  const std::uint64_t square = field & low_bits(2 * w);
  const std::uint64_t root = integer_root(square);
  const std::uint64_t odd = root | 1U;
  return root << (w + 1) | ((square - odd * odd) & low_bits(w + 1));
}

/// Whether the number fits `width` bits of two's complement.
bool fits_signed(Wide number, unsigned width) {
  const Wide half = static_cast<Wide>(1) << (width - 1);
  return -half <= number && number < half;
}

/// F: the low `width` bits as a two's complement number, shifted right with floor.
std::int64_t extract_f(Wide sum, const isa::Linear& linear) {
  const unsigned beyond = 64U - linear.width;
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(sum) << beyond) >> beyond >> linear.shift;
}

bool fits_unsigned(std::int64_t value, unsigned width) { return value >= 0 && value >> width == 0; }

}  // namespace

ReferenceArray::ReferenceArray(isa::Region region, std::uint32_t memory_bits)
    : region_(region),
      words_per_pixel_(memory_bits / bits_per_word + 1),
      memory_(static_cast<std::size_t>(region.width) * region.height * words_per_pixel_),
      words_per_row_((region.width + bits_per_word - 1) / bits_per_word),
      enable_(words_per_row_ * region.height) {}

void ReferenceArray::put(std::size_t pixel, isa::Field field, std::uint64_t value) {
  std::uint64_t* const words = &memory_[pixel * words_per_pixel_ + field.base / bits_per_word];
  const unsigned begin = field.base % bits_per_word;
  const std::uint64_t mask = low_bits(field.width);
  words[0] = (words[0] & ~(mask << begin)) | (value & mask) << begin;
  if (begin + field.width <= bits_per_word) return;
  const unsigned done = bits_per_word - begin;
  words[1] = (words[1] & ~(mask >> done)) | (value & mask) >> done;
}

template <class Act>
void ReferenceArray::at_enabled(const Act& act) {
  for (std::uint32_t y = 0; y < region_.height; ++y) {
    for (std::uint32_t x0 = 0; x0 < region_.width; x0 += bits_per_word) {
      std::uint64_t& word = enable_[enable_word(x0, y)];
      std::uint64_t after = 0;
      for (std::uint64_t left = word; left != 0; left &= left - 1) {
        const auto bit = static_cast<unsigned>(std::countr_zero(left));
        after |= std::uint64_t{act(pixel_at(x0 + bit, y), x0 + bit, y)} << bit;
      }
      word = after;
    }
  }
}

template <class Act>
void ReferenceArray::at_enabled_with_f(const isa::Instruction& instruction, const Act& act) {
  const isa::Linear& linear = instruction.linear;
  const bool has_to_fit = !isa::may_exceed_width(instruction.opcode);
  const bool has_squares = squares_ != isa::Linear{};
  at_enabled([&](std::size_t pixel, std::uint32_t x, std::uint32_t y) {
    Wide sum = exact_sum(linear, x, y);
    if (has_squares) sum += exact_squares(squares_, x, y);
    if (has_to_fit && !fits_signed(sum, linear.width)) ++overflows_;
    return act(pixel, extract_f(sum, linear));
  });
}

template <class NewEnable>
void ReferenceArray::set_enable(const NewEnable& new_enable) {
  for (std::uint32_t y = 0; y < region_.height; ++y) {
    for (std::uint32_t x0 = 0; x0 < region_.width; x0 += bits_per_word) {
      std::uint64_t& word = enable_[enable_word(x0, y)];
      const std::uint32_t pixels = std::min(bits_per_word, region_.width - x0);
      std::uint64_t after = 0;
      for (std::uint32_t bit = 0; bit < pixels; ++bit)
        after |= std::uint64_t{new_enable(pixel_at(x0 + bit, y), (word >> bit & 1U) != 0)} << bit;
      word = after;
    }
  }
}

void ReferenceArray::apply(const isa::Instruction& instruction) {
  using isa::Opcode;
  const isa::Field& first = instruction.fields[0];
  const isa::Field& second = instruction.fields[1];
  const isa::Field& third = instruction.fields[2];
  const auto bits = [&](std::size_t pixel, const isa::Field& field) {
    return static_cast<std::uint64_t>(get(pixel, field));
  };
  const auto bit = [&](std::size_t pixel) { return get(pixel, first) == 1; };
  const auto narrow = [&](const auto& holds) {
    at_enabled([&](std::size_t pixel, auto, auto) { return holds(pixel); });
  };
  const auto narrow_by_f = [&](const auto& holds) {
    at_enabled_with_f(instruction, [&](std::size_t pixel, std::int64_t f) { return holds(f, get(pixel, first)); });
  };
  const auto keep = [&](const auto& holds) {
    at_enabled_with_f(instruction, [&](std::size_t pixel, std::int64_t f) {
      if (!holds(f, get(pixel, first))) return true;
      put(pixel, first, static_cast<std::uint64_t>(f));
      return fits_unsigned(f, first.width);
    });
  };
  const auto store = [&](const auto& value) {
    at_enabled([&](std::size_t pixel, auto, auto) {
      put(pixel, first, value(pixel));
      return true;
    });
  };
  const auto store_with_f = [&](const auto& value) {
    at_enabled_with_f(instruction, [&](std::size_t pixel, std::int64_t f) {
      put(pixel, first, value(static_cast<std::uint64_t>(f), bits(pixel, first)));
      return true;
    });
  };

  switch (instruction.opcode) {
    case Opcode::enable_all: return set_enable([](auto, bool) { return true; });
    case Opcode::enable_invert: return set_enable([](auto, bool e) { return !e; });
    case Opcode::enable_load: return set_enable([&](auto p, bool) { return bit(p); });
    case Opcode::enable_and: return set_enable([&](auto p, bool e) { return e && bit(p); });
    case Opcode::enable_and_not: return set_enable([&](auto p, bool e) { return e && !bit(p); });
    case Opcode::enable_or: return set_enable([&](auto p, bool e) { return e || bit(p); });
    case Opcode::enable_xor: return set_enable([&](auto p, bool e) { return e != bit(p); });
    case Opcode::enable_store:
      return set_enable([&](auto p, bool e) {
        put(p, first, e ? 1 : 0);
        return e;
      });
    case Opcode::edge_not_negative: return narrow_by_f([](auto f, auto) { return f >= 0; });
    case Opcode::edge_negative:
    case Opcode::stripe: return narrow_by_f([](auto f, auto) { return f < 0; });
    case Opcode::linear_ge: return narrow_by_f([](auto f, auto s) { return f >= s; });
    case Opcode::linear_gt: return narrow_by_f([](auto f, auto s) { return f > s; });
    case Opcode::linear_le: return narrow_by_f([](auto f, auto s) { return f <= s; });
    case Opcode::linear_lt: return narrow_by_f([](auto f, auto s) { return f < s; });
    case Opcode::linear_eq: return narrow_by_f([](auto f, auto s) { return f == s; });
    case Opcode::load_linear: return keep([](auto, auto) { return true; });
    case Opcode::keep_max: return keep([](auto f, auto t) { return f > t; });
    case Opcode::keep_min: return keep([](auto f, auto t) { return f < t; });
    case Opcode::set_constant: return store([&](auto) { return instruction.constant; });
    case Opcode::copy: return store([&](auto p) { return bits(p, second); });
    case Opcode::field_lt: return narrow([&](auto p) { return get(p, first) < get(p, second); });
    case Opcode::field_le: return narrow([&](auto p) { return get(p, first) <= get(p, second); });
    case Opcode::field_eq: return narrow([&](auto p) { return get(p, first) == get(p, second); });
    case Opcode::bit_and: return store([&](auto p) { return bits(p, second) & bits(p, third); });
    case Opcode::bit_or: return store([&](auto p) { return bits(p, second) | bits(p, third); });
    case Opcode::bit_xor: return store([&](auto p) { return bits(p, second) ^ bits(p, third); });
    case Opcode::bit_and_not: return store([&](auto p) { return bits(p, second) & ~bits(p, third); });
    case Opcode::bit_not: return store([&](auto p) { return ~bits(p, second); });
    case Opcode::global_or:
    case Opcode::skip_if_none:
    case Opcode::squares: return;
    case Opcode::xor_constant: return store([&](auto p) { return bits(p, first) ^ instruction.constant; });
    case Opcode::add: return store([&](auto p) { return bits(p, first) + bits(p, second); });
    case Opcode::linear_plus: return store_with_f([](auto f, auto t) { return f + t; });
    case Opcode::linear_minus: return store_with_f([](auto f, auto t) { return f - t; });
    case Opcode::root: return store([&](auto p) { return make_rooted_tree(bits(p, first), first.width / 2U); });
  }
}

void ReferenceArray::execute(const isa::Instruction& instruction) {
  apply(instruction);
  squares_ = instruction.opcode == isa::Opcode::squares ? instruction.linear : isa::Linear{};
}

std::uint64_t ReferenceArray::enabled_pixels() const {
  return std::transform_reduce(enable_.begin(), enable_.end(), std::uint64_t{0}, std::plus<>{},
                               [](std::uint64_t word) { return static_cast<std::uint64_t>(std::popcount(word)); });
}

void ReferenceArray::write_enable(std::uint32_t x, std::uint32_t y, bool value) {
  std::uint64_t& word = enable_[enable_word(x, y)];
  const std::uint64_t bit = std::uint64_t{1} << x % bits_per_word;
  word = value ? word | bit : word & ~bit;
}

std::uint32_t ReferenceArray::read(isa::Field field, std::uint32_t x, std::uint32_t y) const {
  return static_cast<std::uint32_t>(get(pixel_at(x, y), field));
}

void ReferenceArray::write(isa::Field field, std::uint32_t x, std::uint32_t y, std::uint32_t value) {
  put(pixel_at(x, y), field, value);
}

void ReferenceArray::read_field(isa::Field field, std::span<std::uint32_t> values) const {
  for (std::size_t pixel = 0; pixel < values.size(); ++pixel)
    values[pixel] = static_cast<std::uint32_t>(get(pixel, field));
}

void ReferenceArray::read_enable(std::span<std::uint64_t> words) const { std::ranges::copy(enable_, words.begin()); }

}  // namespace csgsim::reference
