#include "hw/base/pages.h"

#include "tests/support/test.h"

using namespace csgsim;

TEST_CASE("filled() returns a vector of the given size and value for any page size") {
  for (const std::size_t count : {0U, 1U, 1000U, 16383U, 16384U, 20000U, 262144U, 1048577U, 3000000U}) {
    CAPTURE(count);
    const auto words = filled<std::uint32_t>(count, 0xfedcba98U);
    CHECK(words.size() == count);
    CHECK(std::ranges::all_of(words, [](std::uint32_t word) { return word == 0xfedcba98U; }));
    const auto bytes = filled<std::uint8_t>(count, 7);
    CHECK(std::ranges::count(bytes, 7) == static_cast<std::ptrdiff_t>(count));
  }
}

TEST_CASE("prefault_pages() does not change memory that is already written") {
  std::vector<std::uint64_t> words(1U << 20U);
  for (std::size_t i = 0; i < words.size(); ++i) words[i] = i * i;
  prefault_pages(words.data(), words.size() * sizeof words[0]);
  for (std::size_t i = 0; i < words.size(); ++i) REQUIRE(words[i] == i * i);
}
