#include "sim/functional/word_kernels.h"

#include <doctest/doctest.h>

#include "tests/unit/functional/blocks.h"

using namespace csgsim;
using namespace csgsim::testing;

using Lanes = std::vector<std::uint32_t>;

TEST_CASE("lanes are set where enabled, and nothing else is touched") {
  CHECK(rc::check([] {
    Words enable = any_words();
    Lanes lanes = any_lanes(enable.lanes(), 32);
    const auto value = static_cast<std::uint32_t>(any_word());
    const Words before = enable;
    Lanes expected = lanes;
    enable.for_each([&](std::size_t lane, std::size_t, std::size_t) {
      if (enable.at(lane)) expected[lane] = value;
    });
    sim::set_lanes(enable.block(), lanes.data() + enable.first_lane(), value);
    RC_ASSERT(lanes == expected);
    RC_ASSERT(enable.words == before.words);
  }));
}

TEST_CASE("lanes are copied where enabled, and nothing else is touched") {
  CHECK(rc::check([] {
    Words enable = any_words();
    Lanes target = any_lanes(enable.lanes(), 32);
    const Lanes source = any_lanes(enable.lanes(), 32);
    const Words before = enable;
    Lanes expected = target;
    enable.for_each([&](std::size_t lane, std::size_t, std::size_t) {
      if (enable.at(lane)) expected[lane] = source[lane];
    });
    sim::copy_lanes(enable.block(), target.data() + enable.first_lane(), source.data() + enable.first_lane());
    RC_ASSERT(target == expected);
    RC_ASSERT(enable.words == before.words);
  }));
}

TEST_CASE("lanes are added where enabled, high bits cut off, and nothing else is touched") {
  CHECK(rc::check([] {
    Words enable = any_words();
    const unsigned width = between(1U, 33U);
    Lanes target = any_lanes(enable.lanes(), width);
    const Lanes source = any_lanes(enable.lanes(), between(1U, width + 1));
    const Words before = enable;
    Lanes expected = target;
    enable.for_each([&](std::size_t lane, std::size_t, std::size_t) {
      if (!enable.at(lane)) return;
      const std::uint64_t sum = std::uint64_t{target[lane]} + source[lane];
      expected[lane] = static_cast<std::uint32_t>(sum % (std::uint64_t{1} << width));
    });
    const auto low_bits = static_cast<std::uint32_t>((std::uint64_t{1} << width) - 1);
    sim::add_lanes(enable.block(), target.data() + enable.first_lane(), source.data() + enable.first_lane(), low_bits);
    RC_ASSERT(target == expected);
    RC_ASSERT(enable.words == before.words);
  }));
}

TEST_CASE("a comparison of lanes keeps enabled what holds, as unsigned numbers") {
  CHECK(rc::check([] {
    using sim::Comparison;
    Words enable = any_words();
    const Lanes left = any_lanes(enable.lanes(), between(1U, 33U));
    Lanes right = any_lanes(enable.lanes(), between(1U, 33U));
    for (std::size_t i = 0; i < right.size(); i += 3) right[i] = left[i];
    const auto comparison = *rc::gen::element(Comparison::less, Comparison::less_or_equal, Comparison::equal);
    Words expected = enable;
    enable.for_each([&](std::size_t lane, std::size_t, std::size_t) {
      const std::uint32_t s = left[lane];
      const std::uint32_t r = right[lane];
      const bool in = comparison == Comparison::less            ? s < r
                      : comparison == Comparison::less_or_equal ? s <= r
                                                                : s == r;
      expected.set(lane, enable.at(lane) && in);
    });
    sim::compare_lanes(enable.block(), comparison, left.data() + enable.first_lane(),
                       right.data() + enable.first_lane());
    RC_ASSERT(enable.words == expected.words);
  }));
}

TEST_CASE("a bit of the lanes is gathered into words") {
  CHECK(rc::check([] {
    Words bits = any_words();
    const unsigned bit = between(0U, 32U);
    const Lanes lanes = any_lanes(bits.lanes(), 32);
    Words expected = bits;
    bits.for_each(
        [&](std::size_t lane, std::size_t, std::size_t) { expected.set(lane, (lanes[lane] >> bit & 1U) != 0); });
    sim::gather_bit(bits.block(), lanes.data() + bits.first_lane(), bit);
    RC_ASSERT(bits.words == expected.words);
  }));
}

TEST_CASE("words are scattered into a bit of the lanes that was 0, and the other bits stay") {
  CHECK(rc::check([] {
    Words bits = any_words();
    const unsigned bit = between(0U, 32U);
    Lanes lanes = any_lanes(bits.lanes(), 32);
    for (std::uint32_t& lane : lanes) lane &= ~(std::uint32_t{1} << bit);
    Lanes expected = lanes;
    bits.for_each([&](std::size_t lane, std::size_t, std::size_t) {
      if (bits.at(lane)) expected[lane] += std::uint32_t{1} << bit;
    });
    sim::scatter_bit(bits.block(), lanes.data() + bits.first_lane(), bit);
    RC_ASSERT(lanes == expected);
  }));
}
