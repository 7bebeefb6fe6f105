#include "hw/base/quotient.h"

#include "tests/support/test.h"

using csgsim::quotient_up;

TEST_CASE("quotient_up() returns the smallest number of pieces that covers the amount") {
  for (unsigned amount = 0; amount < 70; ++amount) {
    for (unsigned piece = 1; piece < 70; ++piece) {
      const unsigned pieces = quotient_up(amount, piece);
      CHECK(pieces * piece >= amount);
      if (pieces > 0) CHECK((pieces - 1) * piece < amount);
    }
  }
}

TEST_CASE("quotient_up() does not overflow for the largest amounts") {
  constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  CHECK(quotient_up(most, 2U) == std::uint64_t{1} << 63U);
  CHECK(quotient_up(most, most) == 1);
}
