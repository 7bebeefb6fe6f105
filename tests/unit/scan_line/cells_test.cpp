#include "hw/scan_line/cells.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <array>
#include <vector>

using namespace csgsim;
using scan_line::Cells;
using scan_line::packet_word;
using scan_line::PacketWord;

namespace {

__extension__ using Wide = __int128;

constexpr std::uint32_t cells = 40;

/// The low bits of C + A*x.
std::uint64_t low_bits(const isa::Linear& linear, std::uint32_t x) {
  const Wide sum = static_cast<Wide>(linear.a) * x + linear.c;
  return static_cast<std::uint64_t>(sum) & ((std::uint64_t{1} << linear.width) - 1);
}

std::uint16_t words_of(const isa::Linear& linear, std::uint32_t word_bits) {
  return static_cast<std::uint16_t>((linear.width + word_bits - 1) / word_bits);
}

/// The running sum of every cell, when all words of the packet have been there.
std::vector<std::uint64_t> running_sums(const isa::Linear& linear, std::uint32_t word_bits) {
  Cells chain(cells, 8, word_bits);
  const isa::Instruction instruction{.opcode = isa::Opcode::edge_negative, .linear = linear};
  for (std::uint16_t number = 0; number < words_of(linear, word_bits); ++number) {
    PacketWord word = packet_word(instruction, number, word_bits);
    for (std::uint32_t cell = 0; cell < cells; ++cell) chain.add(cell, word);
  }
  std::vector<std::uint64_t> sums;
  for (std::uint32_t cell = 0; cell < cells; ++cell) {
    sums.push_back(chain.sum(cell) & ((std::uint64_t{1} << linear.width) - 1));
  }
  return sums;
}

}  // namespace

TEST_CASE("the running sum in every cell is C + A*x, wrapped, for every width of F and of a word") {
  CHECK(rc::check([] {
    const std::int64_t a = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::int64_t>(-(1LL << 56), 1LL << 56));
    const std::int64_t c = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::int64_t>(-(1LL << 61), 1LL << 61));
    const auto smaller = *rc::gen::inRange(0U, 62U);
    for (std::uint16_t width = 1; width <= isa::max_linear_width; ++width) {
      const isa::Linear linear{.a = a >> smaller, .c = c >> smaller, .width = width};
      std::vector<std::uint64_t> expected;
      for (std::uint32_t x = 0; x < cells; ++x) expected.push_back(low_bits(linear, x));
      for (std::uint32_t word_bits = 1; word_bits <= 64; ++word_bits) {
        RC_ASSERT(running_sums(linear, word_bits) == expected);
      }
    }
  }));
}

TEST_CASE("the carry of one packet does not reach the next") {
  Cells chain(1, 8, 4);
  const isa::Instruction full{.opcode = isa::Opcode::edge_negative, .linear = {.a = 15, .c = 15, .width = 8}};
  PacketWord word = packet_word(full, 0, 4);
  chain.add(0, word);
  CHECK(word.f == 14);
  PacketWord next = packet_word({.opcode = isa::Opcode::edge_negative, .linear = {.a = 1, .c = 1, .width = 4}}, 0, 4);
  chain.add(0, next);
  CHECK(next.f == 2);
}
