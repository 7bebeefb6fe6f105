// Bit strings with operation counts.
// Used by the bit-sequential and bit-parallel traversals.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/software/cost/operations.h"

namespace csgsim::software {

/// Number of bits in a word of a string.
inline constexpr std::size_t word_bits = 32;

/// Location of a bit string between two operations on it.
enum class Kept : std::uint8_t {
  in_memory,
  in_register,  ///< only if it fits in one word
};

/// A string of bits, initially 0.
template <class Count>
class BitString {
 public:
  BitString(std::size_t bits, Kept kept)
      : words_((bits + word_bits - 1) / word_bits), is_in_memory_(kept == Kept::in_memory || words_.size() > 1) {}

  void flip(std::size_t bit, Count& count) {
    reach(count);
    count(Operation::logic_long);
    put_back(count);
    words_[bit / word_bits] ^= std::uint32_t{1} << (bit % word_bits);
  }

  [[nodiscard]] std::uint32_t get(std::size_t bit, Count& count) const {
    reach(count);
    count(Operation::logic_long);
    return (words_[bit / word_bits] >> (bit % word_bits)) & 1U;
  }

  void set(std::size_t bit, std::uint32_t value, Count& count) {
    reach(count);
    count(Operation::logic_long);
    put_back(count);
    const std::uint32_t mask = std::uint32_t{1} << (bit % word_bits);
    std::uint32_t& word = words_[bit / word_bits];
    word = value != 0 ? word | mask : word & ~mask;
  }

  [[nodiscard]] std::uint64_t word_count() const { return words_.size(); }
  [[nodiscard]] std::span<const std::uint32_t> as_words() const { return words_; }

 private:
  void reach(Count& count) const {
    if (is_in_memory_) count(Operation::load_long);
  }
  void put_back(Count& count) const {
    if (is_in_memory_) count(Operation::store_long);
  }

  std::vector<std::uint32_t> words_;
  bool is_in_memory_;
};

}  // namespace csgsim::software
