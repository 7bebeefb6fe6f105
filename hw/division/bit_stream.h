// Bit streams: writing and reading numbers of arbitrary widths.
// Used by hw/multi_processor.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "hw/base/error.h"
#include "hw/base/quotient.h"

namespace csgsim::division {

/// Bits in transmission order: bit i is bit i mod 64 of words[i / 64]. Bits after the last are 0.
struct Bits {
  std::vector<std::uint64_t> words;
  std::uint64_t count = 0;

  bool operator==(const Bits&) const = default;
};

/// Number of link words of `word_bits` bits for the stream; the last is padded.
constexpr std::uint64_t link_words(std::uint64_t bit_count, std::uint32_t word_bits) {
  return quotient_up(bit_count, word_bits);
}

class BitWriter {
 public:
  /// Appends the low `width` bits of the value, at most 64, least significant first. Higher bits must be 0.
  void put(std::uint64_t value, unsigned width) {
    if (width == 0) return;
    const auto at = static_cast<unsigned>(bits_.count % 64);
    if (at == 0) bits_.words.push_back(0);
    bits_.words.back() |= value << at;
    if (at + width > 64) bits_.words.push_back(value >> (64 - at));
    bits_.count += width;
  }

  /// Appends a number in two's complement.
  void put_signed(std::int64_t value, unsigned width) {
    if (width == 0) return;
    put(static_cast<std::uint64_t>(value) & (~std::uint64_t{0} >> (64 - width)), width);
  }

  [[nodiscard]] Bits take() { return std::move(bits_); }

 private:
  Bits bits_;
};

/// Reads the output of a BitWriter. Throws InputError if the stream ends too soon.
class BitReader {
 public:
  explicit BitReader(const Bits& bits) : bits_(bits) {
    if (bits.words.size() != link_words(bits.count, 64))
      throw InputError(
          "the display model: the number of words does not match the number of bits; compile the model again");
  }

  [[nodiscard]] std::uint64_t left() const { return bits_.count - next_; }

  std::uint64_t take(unsigned width) {
    if (width == 0) return 0;
    if (width > left()) throw InputError("the display model: the stream ends too soon; compile the model again");
    const auto word = static_cast<std::size_t>(next_ / 64);
    const auto at = static_cast<unsigned>(next_ % 64);
    std::uint64_t value = bits_.words[word] >> at;
    if (at + width > 64) value |= bits_.words[word + 1] << (64 - at);
    next_ += width;
    return value & (~std::uint64_t{0} >> (64 - width));
  }

  std::int64_t take_signed(unsigned width) {
    if (width == 0) return 0;
    const std::uint64_t value = take(width);
    return static_cast<std::int64_t>(value << (64 - width)) >> (64 - width);
  }

 private:
  const Bits& bits_;
  std::uint64_t next_ = 0;
};

}  // namespace csgsim::division
