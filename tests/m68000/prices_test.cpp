// Compares figures in hw/processors/*.toml with the clocks of programs on the emulated MC68000.

#include "hw/processors/processor.h"
#include "tests/m68000/mean_clocks.h"
#include "tests/m68000/processor.h"
#include "tests/support/test.h"

using namespace csgsim;
using processors::Compiled;

namespace programs_by_hand {
#include "tests/m68000/programs.inc"
}

namespace {

constexpr std::uint32_t program_at = 0x1000;
constexpr std::uint32_t stack_at = 0x4000;
constexpr std::uint64_t rts_clocks = 16;

struct Quotient {
  std::uint32_t quotient;
  std::uint32_t remainder;
  std::uint64_t clocks;  ///< without the clocks of RTS
};

Quotient divided(std::uint64_t number, std::uint32_t divisor) {
  m68000::Processor processor(stack_at);
  std::uint32_t at = program_at;
  for (const std::uint16_t word : programs_by_hand::words) {
    processor.write(at, m68000::Size::word, word);
    at += 2;
  }
  processor.a[7] = stack_at;
  processor.d[0] = static_cast<std::uint32_t>(number >> 32U);
  processor.d[1] = static_cast<std::uint32_t>(number);
  processor.d[2] = divisor;
  processor.call(programs_by_hand::divide_long_at, 1000);
  return {processor.d[1], processor.d[0], processor.clocks() - rts_clocks};
}

std::uint32_t price_of(const processors::Processor& processor, processors::Operation kind) {
  return processor.prices[static_cast<std::size_t>(kind)];
}

struct Factor {
  Compiled program;
  m68000::Method method;
};

constexpr std::array factors{
    Factor{Compiled::standard, m68000::Method::standard}, Factor{Compiled::early_out, m68000::Method::early_out},
    Factor{Compiled::positional, m68000::Method::positional}, Factor{Compiled::status, m68000::Method::status_tree},
    Factor{Compiled::bit_parallel, m68000::Method::bit_parallel}};

/// The factor in thousandths, rounded to two decimals.
std::uint32_t measured(m68000::Method method, m68000::Written written) {
  const double factor = mean_clocks(method, written).clocks / mean_clocks(method, m68000::Written::by_hand).clocks;
  return static_cast<std::uint32_t>(10 * std::lround(100 * factor));
}

}  // namespace

TEST_CASE("a division of 64 by 32 bits is correct and takes the clocks of its instructions") {
  // MOVEQ 4; 32 times ADD.L 8, ROXL.L #1 10, CMP.L 6 and DBRA 10, the last DBRA 14; for each digit 0 BCS taken 10; for
  // each digit 1 BCS not taken 8, SUB.L 8, ADDQ.W 4.
  constexpr std::uint64_t always = 4 + 32 * (8 + 10 + 6 + 10) + 4;
  constexpr std::uint64_t zero = 10;
  constexpr std::uint64_t one = 8 + 8 + 4;
  std::uint64_t number = 0x0123'4567'89ab'cdef;
  for (int i = 0; i < 500; ++i) {
    number = number * 6364136223846793005U + 1442695040888963407U;
    const auto divisor = static_cast<std::uint32_t>((number >> 33U) | 1U);
    const std::uint64_t dividend = (number * 0x9e37'79b9'7f4a'7c15U) % (std::uint64_t{divisor} << 32U);
    const Quotient found = divided(dividend, divisor);
    CHECK(found.quotient == dividend / divisor);
    CHECK(found.remainder == dividend % divisor);
    const auto ones = static_cast<std::uint64_t>(std::popcount(found.quotient));
    CHECK(found.clocks == always + ones * one + (32 - ones) * zero);
  }
}

TEST_CASE("the price of a 64-bit division is that of a quotient with half of its bits 1") {
  const Quotient found = divided(0x5555'5555ULL * 3, 3);
  REQUIRE(std::popcount(found.quotient) == 16);
  CHECK(found.clocks == 1576);
  CHECK(price_of(processors::load_processor("mc68000"), processors::Operation::divide_long) == found.clocks);
}

TEST_CASE("the compiler factors of methods equal those measured for their C programs") {
  const processors::Processor plain = processors::load_processor("mc68000");
  const processors::Processor optimised = processors::load_processor("i486dx2");
  for (const Factor& one : factors) {
    const auto place = static_cast<std::size_t>(one.program);
    CAPTURE(place);
    CHECK(plain.compiler_factors[place] == measured(one.method, m68000::Written::compiled_plainly));
    CHECK(optimised.compiler_factors[place] == measured(one.method, m68000::Written::compiled_optimised));
  }
}
