#include "host/effects/screen_door.h"

#include <array>
#include <bit>

#include "hw/isa/opcodes.h"

namespace csgsim::effects {

namespace {

/// A bit of M: bit `width` - 1 of a linear expression.
struct PatternBit {
  view::FixedLinear line;
  unsigned width;
};

/// The bits of M, lowest first.
constexpr std::array<PatternBit, 4> bits_of_m{PatternBit{{0, 1, 0}, 2}, PatternBit{{1, 1, 0}, 2},
                                              PatternBit{{0, 1, 0}, 1}, PatternBit{{1, 1, 0}, 1}};

/// Leaves E at 1 where M is one of 2^size numbers, beginning with `first`, a multiple of 2^size. M < 2^known must
/// already hold.
void emit_block(emit::Broadcast& out, unsigned first, unsigned size, unsigned known) {
  for (unsigned bit = known; bit-- > size;) {
    const bool is_one = ((first >> bit) & 1U) != 0;
    const PatternBit& pattern = bits_of_m.at(bit);
    const std::int64_t turned = is_one ? 0 : std::int64_t{1} << (pattern.width - 1);
    out.stripe({pattern.line.a, pattern.line.b, pattern.line.c + turned}, pattern.width);
  }
}

}  // namespace

void emit_screen_door(emit::Broadcast& out, unsigned pixels, isa::Field spare) {
  if (pixels >= max_pattern_pixels) return;
  if (pixels == 0) {
    out.disable_all();
    return;
  }
  // Restricts M to the smallest sufficient power of two, then excludes blocks of surplus numbers.
  const auto known = static_cast<unsigned>(std::bit_width(pixels - 1));
  emit_block(out, 0, known, bits_of_m.size());
  for (unsigned first = pixels; first < 1U << known;) {
    const auto size = static_cast<unsigned>(std::countr_zero(first));
    out.plain(isa::Opcode::enable_store, spare);
    emit_block(out, first, size, known);
    out.plain(isa::Opcode::enable_xor, spare);
    first += 1U << size;
  }
}

}  // namespace csgsim::effects
