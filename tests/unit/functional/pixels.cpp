#include "tests/unit/functional/pixels.h"

namespace csgsim::testing {

std::uint64_t any_word() {
  const auto word = [] { return *rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()); };
  switch (between(0, 6)) {
    case 0: return 0;
    case 1: return ~std::uint64_t{0};
    case 2: return word() & word() & word();
    case 3: return std::uint64_t{1} << between(0U, 64U);
    default: return word();
  }
}

std::uint64_t Pixels::ones() const {
  std::uint64_t ones = 0;
  for (const bool bit : bits_) ones += bit ? 1 : 0;
  return ones;
}

sim::Rect Pixels::bounds() const {
  sim::Rect bounds;
  for (std::uint32_t y = 0; y < height_; ++y)
    for (std::uint32_t x = 0; x < width_; ++x)
      if (at(x, y)) bounds = sim::hull(bounds, {x, y, x + 1, y + 1});
  return bounds;
}

bool holds(const sim::Rect& rect, std::uint32_t x, std::uint32_t y) {
  return rect.x0 <= x && x < rect.x1 && rect.y0 <= y && y < rect.y1;
}

Pixels pixels_of(const sim::BitPlane& plane) {
  Pixels pixels(plane.whole().x1, plane.whole().y1);
  for (std::uint32_t y = 0; y < pixels.height(); ++y) {
    for (std::uint32_t x = 0; x < plane.words_per_row() * sim::word_bits; ++x) {
      const bool bit = (plane.word(y, x / sim::word_bits) >> (x % sim::word_bits) & 1U) != 0;
      if (x < pixels.width()) {
        pixels.set(x, y, bit);
      } else {
        RC_ASSERT_FALSE(bit);
      }
    }
  }
  return pixels;
}

Pixels any_size() {
  const auto any = between<std::uint32_t>(1, 200);
  const auto width = *rc::gen::element<std::uint32_t>(1, 7, 63, 64, 65, 128, 129, any);
  return {width, between<std::uint32_t>(1, 5)};
}

sim::Rect any_rect(const sim::Rect& within) {
  if (within.empty()) return {};
  const sim::Rect rect{between(within.x0, within.x1), between(within.y0, within.y1), between(within.x0, within.x1 + 1),
                       between(within.y0, within.y1 + 1)};
  return rect.empty() ? sim::Rect{} : rect;
}

Pixels set_any(sim::BitPlane& plane) {
  Pixels pixels(plane.whole().x1, plane.whole().y1);
  const sim::Rect rect = between(0, 4) == 0 ? plane.whole() : any_rect(plane.whole());
  plane.fill(rect);
  pixels.set_each([&](std::uint32_t x, std::uint32_t y) { return holds(rect, x, y); });
  if (between(0, 3) == 0) return pixels;
  plane.materialise();
  for (std::uint32_t y = rect.y0; y < rect.y1; ++y) {
    for (std::uint32_t column = rect.x0 / 64; column * 64 < rect.x1; ++column) {
      const std::uint64_t word = any_word();
      std::uint64_t kept = 0;
      for (std::uint32_t bit = 0; bit < 64; ++bit) {
        const std::uint32_t x = column * 64 + bit;
        if (!holds(rect, x, y)) continue;
        pixels.set(x, y, (word >> bit & 1U) != 0);
        kept |= word & std::uint64_t{1} << bit;
      }
      plane.set_word(y, column, kept);
    }
  }
  return pixels;
}

}  // namespace csgsim::testing
