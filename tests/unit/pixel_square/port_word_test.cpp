#include "hw/pixel_square/port_word.h"

#include <rapidcheck.h>

#include "tests/support/test.h"
#include "tests/unit/pixel_square/bench.h"

using namespace csgsim;

TEST_CASE("consecutive numbers survive slicing at any width") {
  CHECK(rc::check([] {
    std::vector<bool> expected;
    std::vector<std::uint64_t> bits(64);
    while (expected.size() < 3000 && *rc::gen::inRange(0, 40) > 0) {
      const unsigned count = *rc::gen::inRange(0U, 65U);
      const std::uint64_t any = *rc::gen::arbitrary<std::uint64_t>();
      const std::uint64_t value = count == 64 ? any : any & ((std::uint64_t{1} << count) - 1);
      pixel_square::put_bits(bits, expected.size(), count, value);
      testing::add_bits(expected, value, count);
    }
    const std::uint32_t width = *rc::gen::inRange(1U, 200U);
    bits.resize((expected.size() + 63) / 64);
    std::vector<pixel_square::PortWord> words;
    for (std::uint64_t first = 0; first < expected.size(); first += width)
      words.push_back({pixel_square::slice_of(bits, first, width)});
    while (expected.size() % width != 0) expected.push_back(false);
    RC_ASSERT(testing::bits_of(words, width) == expected);
    for (const pixel_square::PortWord& word : words) {
      RC_ASSERT(word.bits.size() == (width + 63) / 64);
      if (width % 64 != 0) RC_ASSERT(word.bits.back() >> (width % 64) == 0U);
    }
  }));
}

TEST_CASE("a header holds x and y and width and height from the lowest bits up") {
  CHECK(pixel_square::header_of({0x1234, 0x5678, 0x9abc, 0xdef0}) == 0xdef0'9abc'5678'1234);
  CHECK(rc::check([] {
    const auto number = [] { return *rc::gen::inRange(0U, 65536U); };
    const isa::Region region{number(), number(), number(), number()};
    RC_ASSERT(pixel_square::region_of(pixel_square::header_of(region)) == region);
  }));
}
