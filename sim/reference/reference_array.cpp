#include "sim/reference/reference_array.h"

#include <algorithm>

#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"

namespace csgsim::reference {

namespace {

__extension__ using Wide = __int128;

/// A*x + B*y + C, exactly.
Wide exact_sum(const isa::Linear& linear, std::uint32_t x, std::uint32_t y) {
  return static_cast<Wide>(linear.a) * x + static_cast<Wide>(linear.b) * y + linear.c;
}

/// A*x*x + B*x*y + C*y*y, exactly.
Wide exact_squares(const isa::Linear& squares, std::uint32_t x, std::uint32_t y) {
  return static_cast<Wide>(squares.a) * x * x + static_cast<Wide>(squares.b) * x * y +
         static_cast<Wide>(squares.c) * y * y;
}

/// The greatest number whose square is no more than that, which is below 2^60.
std::uint64_t root_of(std::uint64_t square) {
  std::uint64_t least = 0;
  std::uint64_t beyond = std::uint64_t{1} << 30U;
  while (beyond - least > 1) {
    const std::uint64_t middle = (least + beyond) / 2;
    (middle * middle <= square ? least : beyond) = middle;
  }
  return least;
}

/// What `root` makes of a field of 2w + 1 bits.
std::uint64_t with_root(std::uint64_t field, unsigned w) {
  const std::uint64_t square = field & ((std::uint64_t{1} << 2 * w) - 1);
  const std::uint64_t root = root_of(square);
  const std::uint64_t odd = root | 1U;
  const std::uint64_t low_bits = (std::uint64_t{2} << w) - 1;
  return root << (w + 1) | ((square - odd * odd) & low_bits);
}

/// Does the number fit `width` bits of two's complement?
bool fits_signed(Wide number, unsigned width) {
  const Wide half = static_cast<Wide>(1) << (width - 1);
  return -half <= number && number < half;
}

/// F: the low `width` bits as a two's complement number, shifted right with floor.
std::int64_t value_of_f(Wide sum, const isa::Linear& linear) {
  const auto bits = static_cast<std::uint64_t>(sum);
  std::int64_t number = 0;
  for (unsigned bit = 0; bit + 1 < linear.width; ++bit) number += static_cast<std::int64_t>(bits >> bit & 1U) << bit;
  const unsigned sign = linear.width - 1U;
  if ((bits >> sign & 1U) != 0) number -= std::int64_t{1} << sign;
  return number >> linear.shift;
}

bool fits_unsigned(std::int64_t value, unsigned width) { return value >= 0 && value >> width == 0; }

}  // namespace

ReferenceArray::ReferenceArray(isa::Region region, std::uint32_t memory_bits)
    : region_(region),
      memory_bits_(memory_bits),
      memory_(static_cast<std::size_t>(region.width) * region.height * memory_bits),
      enable_(static_cast<std::size_t>(region.width) * region.height) {}

std::int64_t ReferenceArray::get(std::size_t pixel, isa::Field field) const {
  std::int64_t value = 0;
  for (unsigned bit = 0; bit < field.width; ++bit)
    value += std::int64_t{memory_[pixel * memory_bits_ + field.base + bit]} << bit;
  return value;
}

void ReferenceArray::put(std::size_t pixel, isa::Field field, std::uint64_t value) {
  for (unsigned bit = 0; bit < field.width; ++bit)
    memory_[pixel * memory_bits_ + field.base + bit] = static_cast<Bit>(value >> bit & 1U);
}

void ReferenceArray::put_linear(std::size_t pixel, isa::Field field, std::int64_t value) {
  put(pixel, field, static_cast<std::uint64_t>(value));
  if (!fits_unsigned(value, field.width)) enable_[pixel] = 0;
}

/// 0 where E is 0: no instruction looks at F there.
std::int64_t ReferenceArray::f_at(std::uint32_t x, std::uint32_t y, const isa::Instruction& instruction) {
  if (!enabled(x, y) || !isa::has_operand(isa::operands_of(instruction.opcode), isa::OperandKind::linear)) return 0;
  const Wide sum = exact_sum(instruction.linear, x, y) + exact_squares(squares_, x, y);
  if (!isa::cuts_sum(instruction.opcode) && !fits_signed(sum, instruction.linear.width)) ++overflows_;
  return value_of_f(sum, instruction.linear);
}

void ReferenceArray::execute_at(std::uint32_t x, std::uint32_t y, const isa::Instruction& instruction) {
  using isa::Opcode;
  const std::size_t pixel = pixel_at(x, y);
  const isa::Field& first = instruction.fields[0];
  const isa::Field& second = instruction.fields[1];
  const isa::Field& third = instruction.fields[2];
  const bool e = enable_[pixel] != 0;
  const auto set_enable = [&](bool one) { write_enable(x, y, one); };
  const auto bits = [&](isa::Field field) { return static_cast<std::uint64_t>(get(pixel, field)); };
  const auto store = [&](auto value) {
    if (e) put(pixel, first, value());
  };
  const std::int64_t f = f_at(x, y, instruction);
  const auto keep = [&](bool where) {
    if (where) put_linear(pixel, first, f);
  };

  switch (instruction.opcode) {
    case Opcode::enable_all: return set_enable(true);
    case Opcode::enable_invert: return set_enable(!e);
    case Opcode::enable_load: return set_enable(get(pixel, first) == 1);
    case Opcode::enable_and: return set_enable(e && get(pixel, first) == 1);
    case Opcode::enable_and_not: return set_enable(e && get(pixel, first) == 0);
    case Opcode::enable_or: return set_enable(e || get(pixel, first) == 1);
    case Opcode::enable_xor: return set_enable(e != (get(pixel, first) == 1));
    case Opcode::enable_store: return put(pixel, first, e ? 1 : 0);
    case Opcode::edge_not_negative: return set_enable(e && f >= 0);
    case Opcode::edge_negative:
    case Opcode::stripe: return set_enable(e && f < 0);
    case Opcode::linear_ge: return set_enable(e && f >= get(pixel, first));
    case Opcode::linear_gt: return set_enable(e && f > get(pixel, first));
    case Opcode::linear_le: return set_enable(e && f <= get(pixel, first));
    case Opcode::linear_lt: return set_enable(e && f < get(pixel, first));
    case Opcode::linear_eq: return set_enable(e && f == get(pixel, first));
    case Opcode::load_linear: return keep(e);
    case Opcode::keep_max: return keep(e && f > get(pixel, first));
    case Opcode::keep_min: return keep(e && f < get(pixel, first));
    case Opcode::set_constant: return store([&] { return instruction.constant; });
    case Opcode::copy: return store([&] { return bits(second); });
    case Opcode::field_lt: return set_enable(e && get(pixel, first) < get(pixel, second));
    case Opcode::field_le: return set_enable(e && get(pixel, first) <= get(pixel, second));
    case Opcode::field_eq: return set_enable(e && get(pixel, first) == get(pixel, second));
    case Opcode::bit_and: return store([&] { return bits(second) & bits(third); });
    case Opcode::bit_or: return store([&] { return bits(second) | bits(third); });
    case Opcode::bit_xor: return store([&] { return bits(second) ^ bits(third); });
    case Opcode::bit_and_not: return store([&] { return bits(second) & ~bits(third); });
    case Opcode::bit_not: return store([&] { return ~bits(second); });
    case Opcode::global_or:
    case Opcode::skip_if_none:
    case Opcode::squares: return;
    case Opcode::xor_constant: return store([&] { return bits(first) ^ instruction.constant; });
    case Opcode::add: return store([&] { return bits(first) + bits(second); });
    case Opcode::linear_plus: return store([&] { return static_cast<std::uint64_t>(f) + bits(first); });
    case Opcode::linear_minus: return store([&] { return static_cast<std::uint64_t>(f) - bits(first); });
    case Opcode::root: return store([&] { return with_root(bits(first), first.width / 2U); });
  }
}

void ReferenceArray::execute(const isa::Instruction& instruction) {
  for (std::uint32_t y = 0; y < region_.height; ++y)
    for (std::uint32_t x = 0; x < region_.width; ++x) execute_at(x, y, instruction);
  squares_ = instruction.opcode == isa::Opcode::squares ? instruction.linear : isa::Linear{};
}

std::uint64_t ReferenceArray::enabled_pixels() const {
  return static_cast<std::uint64_t>(std::count(enable_.begin(), enable_.end(), Bit{1}));
}

std::uint32_t ReferenceArray::read(isa::Field field, std::uint32_t x, std::uint32_t y) const {
  return static_cast<std::uint32_t>(get(pixel_at(x, y), field));
}

void ReferenceArray::write(isa::Field field, std::uint32_t x, std::uint32_t y, std::uint32_t value) {
  put(pixel_at(x, y), field, value);
}

void ReferenceArray::read_field(isa::Field field, std::span<std::uint32_t> values) const {
  for (std::size_t pixel = 0; pixel < enable_.size(); ++pixel)
    values[pixel] = static_cast<std::uint32_t>(get(pixel, field));
}

void ReferenceArray::read_enable(std::span<std::uint64_t> words) const {
  const std::size_t words_a_row = (region_.width + 63U) / 64U;
  std::fill(words.begin(), words.end(), 0U);
  for (std::uint32_t y = 0; y < region_.height; ++y)
    for (std::uint32_t x = 0; x < region_.width; ++x)
      if (enabled(x, y)) words[y * words_a_row + x / 64U] |= std::uint64_t{1} << x % 64U;
}

}  // namespace csgsim::reference
