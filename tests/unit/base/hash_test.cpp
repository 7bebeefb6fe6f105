#include "hw/base/hash.h"

#include <rapidcheck.h>

#include "tests/support/test.h"

using namespace csgsim;

TEST_CASE("Hash computes FNV-1a of the bytes") {
  // Values from appendix C of draft-eastlake-fnv.
  Hash nothing;
  CHECK(nothing.value() == 0xcbf29ce484222325ULL);
  Hash letter;
  letter.add("a");
  CHECK(letter.value() == 0xaf63dc4c8601ec8cULL);
  Hash word;
  word.add("foobar");
  CHECK(word.value() == 0x85944171f73967e8ULL);
}

TEST_CASE("Hash hashes words as their bytes in little-endian order") {
  CHECK(rc::check([] {
    const auto words = *rc::gen::container<std::vector<std::uint32_t>>(
        rc::gen::apply([](std::uint32_t word, unsigned bits) { return bits == 0 ? 0U : word >> (32U - bits); },
                       rc::gen::arbitrary<std::uint32_t>(), rc::gen::inRange(0U, 33U)));
    std::string bytes;
    for (const std::uint32_t word : words) {
      for (unsigned shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(word >> shift & 0xffU);
    }
    Hash of_words;
    of_words.add(words);
    Hash of_bytes;
    of_bytes.add(bytes);
    RC_ASSERT(of_words.value() == of_bytes.value());
  }));
}
