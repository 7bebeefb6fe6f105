#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "hw/array/array_step.h"
#include "hw/array/plane.h"
#include "hw/array/stream_bit.h"

/// Steps that the pixels have still to carry out. As no pixel reads another's bits, they may be carried out block of
/// pixels by block of pixels, all steps of a block one after the other.
namespace csgsim::array {

/// Where a pixel's bits lie beside each other: the carry, the flag, the latch, the memory, and perhaps the registers
/// between the trees and the pixel.
struct PixelBits {
  unsigned alu_bits = 1;
  unsigned memory_bits = 0;
  unsigned tree_bits = 0;  ///< of those registers; where there are none a stream's coefficients stand for them

  static constexpr unsigned carry = 0;
  static constexpr unsigned flag = 1;
  [[nodiscard]] constexpr unsigned latch(unsigned bit) const { return 2 + bit; }
  [[nodiscard]] constexpr unsigned memory(unsigned address) const { return 2 + alu_bits + address; }
  [[nodiscard]] constexpr unsigned tree(unsigned bit) const { return memory(memory_bits) + bit; }
  [[nodiscard]] constexpr unsigned count() const { return tree(tree_bits); }
};

/// The carry before the first of a run's steps.
enum class CarryIn : std::uint8_t { keep, zero, one };

/// One function on adjacent bits, one after the other. Functions that differ from another only in the carry before them
/// are that other: of compare_from_0, compare_from_1, less_from_0, less_from_1, sum_from_0, sum_with_1_from_0 and
/// difference_from_1 there is no run.
struct Run {
  AluFunction function = AluFunction::idle;
  CarryIn carry_in = CarryIn::keep;
  bool from_tree = false;        ///< operand x is bits of a stream
  bool latches = false;          ///< operand x goes into the first bit of the latch as well
  std::uint16_t stream = 0;      ///< of the batch
  std::uint16_t stream_bit = 0;  ///< the first bit of it
  std::uint16_t count = 0;       ///< bits, 1 to 64
  std::uint16_t x = 0;           ///< the pixel's bits, by PixelBits, that the first step works on
  std::uint16_t y = 0;
  std::uint16_t write = 0;
  std::uint64_t constant = 0;  ///< a bit a step
};

/// A stream whose bits operand x takes, with as much of its coefficients as the bits need.
struct Stream {
  std::uint64_t a = 0;
  std::uint64_t b = 0;
  std::uint64_t c = 0;
  std::uint64_t xx = 0;
  std::uint64_t xy = 0;
  std::uint64_t yy = 0;
  unsigned bits = 0;  ///< of the coefficients that are there
};

/// What steps do to a register besides the enable bit.
enum class Touch : std::uint8_t {
  none,
  uses,  ///< what they leave depends on what was there, or they do not write all of it
  sets,  ///< they write it before they read it
};

/// Some of a pixel's bits.
class BitSet {
 public:
  void add(unsigned bit) {
    if (bit / word_bits >= words_.size()) words_.resize(bit / word_bits + 1);
    words_[bit / word_bits] |= std::uint64_t{1} << bit % word_bits;
  }
  void clear() { words_.clear(); }
  [[nodiscard]] bool has(unsigned bit) const {
    return bit / word_bits < words_.size() && (words_[bit / word_bits] >> bit % word_bits & 1U) != 0;
  }
  [[nodiscard]] bool meets(const BitSet& other) const {
    const std::size_t words = std::min(words_.size(), other.words_.size());
    for (std::size_t i = 0; i < words; ++i)
      if ((words_[i] & other.words_[i]) != 0) return true;
    return false;
  }

 private:
  std::vector<std::uint64_t> words_;
};

/// Steps that are carried out together.
struct Batch {
  std::vector<Run> runs;
  std::vector<Stream> streams;
  Touch carry = Touch::none;
  Touch latch = Touch::none;
  Touch flag = Touch::none;
  bool acts_where_disabled = false;  ///< on enable or memory of pixels that are not enabled
  BitSet reads;                      ///< memory
  BitSet writes;                     ///< memory

  [[nodiscard]] bool empty() const { return runs.empty(); }
  void clear();
};

/// Gathers steps clock by clock.
class StepLog {
 public:
  explicit StepLog(PixelBits bits) : bits_(bits) {}

  /// The step of a clock, in which `tree` is at the pixels; null: what their registers have.
  void push(const ArrayStep& step, const StreamBit* tree);

  [[nodiscard]] const Batch& batch() const { return batch_; }
  void clear() { batch_.clear(); }
  /// Hands the batch over, in place of another, which is cleared.
  void take(Batch& batch) {
    std::swap(batch, batch_);
    batch_.clear();
  }

 private:
  void push_bit(const ArrayStep& step, unsigned bit, const StreamBit* tree, bool latches);
  void append(const Run& run);
  void note(const Run& run);
  [[nodiscard]] bool takes_latch(const ArrayStep& step) const;
  std::uint16_t stream_of(const StreamBit& tree);

  PixelBits bits_;
  Batch batch_;
};

}  // namespace csgsim::array
