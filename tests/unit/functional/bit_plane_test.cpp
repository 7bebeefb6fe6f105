#include "sim/functional/bit_plane.h"

#include <doctest/doctest.h>

#include "tests/unit/functional/pixels.h"

using namespace csgsim;
using namespace csgsim::testing;
using sim::BitPlane;
using sim::Rect;

namespace {

/// Clears what the caller of narrow has to: ones outside the rectangle that share a word with a pixel inside.
void clear_around(BitPlane& plane, const Rect& rect) {
  for (std::uint32_t y = rect.y0; y < rect.y1; ++y) {
    for (std::uint32_t column = rect.x0 / 64; column * 64 < rect.x1; ++column) {
      std::uint64_t word = plane.word(y, column);
      for (std::uint32_t bit = 0; bit < 64; ++bit) {
        if (!holds(rect, column * 64 + bit, y)) word &= ~(std::uint64_t{1} << bit);
      }
      plane.set_word(y, column, word);
    }
  }
}

/// Does one of the things that a plane can do, to the plane and to its pixels.
void do_any(BitPlane& plane, Pixels& pixels) {
  const Rect rect = any_rect(plane.whole());
  const Rect inside = any_rect(plane.bounds());
  switch (between(0, 7)) {
    case 0: pixels = set_any(plane); break;
    case 1:
      plane.clear();
      pixels.set_each([](std::uint32_t, std::uint32_t) { return false; });
      break;
    case 2: plane.materialise(); break;
    case 3:
      plane.cover(rect);
      RC_ASSERT_FALSE(plane.solid());
      RC_ASSERT(sim::contains(plane.bounds(), rect));
      break;
    case 4:
      if (!plane.solid()) clear_around(plane, inside);
      plane.narrow(inside);
      pixels.set_each([&](std::uint32_t x, std::uint32_t y) { return pixels.at(x, y) && holds(inside, x, y); });
      RC_ASSERT(plane.bounds() == inside);
      break;
    case 5: {
      BitPlane other(pixels.width(), pixels.height());
      pixels = set_any(other);
      plane.assign(other);
      break;
    }
    default: RC_ASSERT(sim::settle(plane) == pixels.ones()); RC_ASSERT(plane.bounds() == pixels.bounds());
  }
}

}  // namespace

TEST_CASE("bits between two places are those, wherever the places are") {
  for (std::int64_t from = -66; from <= 130; ++from) {
    for (std::int64_t to = -66; to <= 130; ++to) {
      std::uint64_t expected = 0;
      for (std::int64_t bit = 0; bit < 64; ++bit) {
        if (from <= bit && bit < to) expected |= std::uint64_t{1} << bit;
      }
      REQUIRE(sim::bits_between(from, to) == expected);
    }
  }
}

TEST_CASE("the cells of a rectangle are the words that hold a pixel of it") {
  CHECK(rc::check([] {
    const Rect rect = any_rect({0, 0, 200, 5});
    const sim::Cells cells(rect);
    for (std::uint32_t row = 0; row < 6; ++row) {
      for (std::uint32_t column = 0; column < 4; ++column) {
        bool any = false;
        for (std::uint32_t bit = 0; bit < 64; ++bit) any |= holds(rect, column * 64 + bit, row);
        RC_ASSERT(cells.holds(row, column) == any);
      }
    }
  }));
}

TEST_CASE("a plane holds what was done to it, whatever its storage held before") {
  CHECK(rc::check([] {
    Pixels pixels = any_size();
    BitPlane plane(pixels.width(), pixels.height());
    const int steps = between(1, 12);
    for (int i = 0; i < steps; ++i) {
      do_any(plane, pixels);
      RC_ASSERT(pixels_of(plane) == pixels);
    }
  }));
}

TEST_CASE("ones of a block are counted and bounded from the block's first pixel") {
  CHECK(rc::check([] {
    const Pixels size = any_size();
    BitPlane plane(size.width(), size.height());
    set_any(plane);
    plane.cover(plane.whole());
    Rect rect = any_rect(plane.whole());
    rect.x0 = rect.x0 / 64 * 64;
    if (rect.empty()) return;
    Pixels inside = pixels_of(plane);
    const std::uint32_t end = (rect.x1 + 63) / 64 * 64;
    inside.set_each([&](std::uint32_t x, std::uint32_t y) {
      return inside.at(x, y) && holds({rect.x0, rect.y0, end, rect.y1}, x, y);
    });
    const sim::Tally counted = sim::tally(plane.block(rect));
    const Rect bounds = inside.bounds();
    RC_ASSERT(counted.ones == inside.ones());
    if (bounds.empty()) {
      RC_ASSERT(counted.bounds.empty());
    } else {
      const Rect expected{bounds.x0 - rect.x0, bounds.y0 - rect.y0, bounds.x1 - rect.x0, bounds.y1 - rect.y0};
      RC_ASSERT(counted.bounds == expected);
    }
  }));
}

TEST_CASE("write_where writes where the enable plane is 1, and nowhere else") {
  CHECK(rc::check([] {
    const Pixels size = any_size();
    BitPlane e(size.width(), size.height());
    BitPlane target(size.width(), size.height());
    BitPlane value(size.width(), size.height());
    const Pixels enabled = set_any(e);
    Pixels expected = set_any(target);
    const Pixels written = set_any(value);
    expected.set_each(
        [&](std::uint32_t x, std::uint32_t y) { return enabled.at(x, y) ? written.at(x, y) : expected.at(x, y); });
    sim::write_where(e, target, value.bounds(),
                     [&](std::uint32_t row, std::uint32_t column) { return value.word(row, column); });
    RC_ASSERT(pixels_of(target) == expected);
    RC_ASSERT(sim::contains(target.bounds(), expected.bounds()));
  }));
}
