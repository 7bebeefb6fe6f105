// Log of pending bit steps, merged into runs.
// Used by DeferredPixels and its kernels.
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

// A log of steps that the pixels have not executed yet. No pixel reads bits of another, so the steps can be executed
// block of pixels by block of pixels, all steps of a block in one go.
namespace csgsim::array {

/// Indices of a pixel's bits: carry, flag, latch, memory, and optionally the registers between the trees and the pixel.
struct PixelBits {
  unsigned alu_bits = 1;
  unsigned memory_bits = 0;
  /// Width of the registers between trees and pixels; 0 if the stream's coefficients represent them.
  unsigned tree_bits = 0;

  static constexpr unsigned carry = 0;
  static constexpr unsigned flag = 1;
  [[nodiscard]] constexpr unsigned latch(unsigned bit) const { return 2 + bit; }
  [[nodiscard]] constexpr unsigned memory(unsigned address) const { return 2 + alu_bits + address; }
  [[nodiscard]] constexpr unsigned tree(unsigned bit) const { return memory(memory_bits) + bit; }
  [[nodiscard]] constexpr unsigned count() const { return tree(tree_bits); }
};

/// Carry into the first step of a run.
enum class CarryIn : std::uint8_t { keep, zero, one };

/// One function applied to adjacent bits, one after another. Functions that differ only in their initial carry share
/// one entry: there are no runs of compare_from_0, compare_from_1, less_from_0, less_from_1, sum_from_0,
/// sum_with_1_from_0 and difference_from_1.
struct Run {
  AluFunction function = AluFunction::idle;
  CarryIn carry_in = CarryIn::keep;
  bool from_tree = false;        ///< whether operand x is bits of a stream
  bool latches = false;          ///< whether operand x is also stored in the first bit of the latch
  std::uint16_t stream = 0;      ///< index of the stream in the batch
  std::uint16_t stream_bit = 0;  ///< first bit of the stream
  std::uint16_t count = 0;       ///< bits, 1 to 64
  std::uint16_t x = 0;           ///< x, y, write: bits of the pixel (PixelBits) for the first step
  std::uint16_t y = 0;
  std::uint16_t write = 0;
  std::uint64_t constant = 0;  ///< one bit per step
};

/// A stream that supplies operand x, with the low bits of its coefficients that the steps need.
struct Stream {
  std::uint64_t a = 0;
  std::uint64_t b = 0;
  std::uint64_t c = 0;
  std::uint64_t xx = 0;
  std::uint64_t xy = 0;
  std::uint64_t yy = 0;
  unsigned bits = 0;  ///< number of valid bits of the coefficients
};

/// How the steps of a batch access a register other than the enable bit.
enum class Touch : std::uint8_t {
  none,
  uses,  ///< the result depends on the old value, or part of the register is not written
  sets,  ///< written before it is read
};

/// A set of a pixel's bits.
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
  [[nodiscard]] bool intersects(const BitSet& other) const {
    const std::size_t words = std::min(words_.size(), other.words_.size());
    for (std::size_t i = 0; i < words; ++i)
      if ((words_[i] & other.words_[i]) != 0) return true;
    return false;
  }

 private:
  std::vector<std::uint64_t> words_;
};

/// Steps that are executed together.
struct Batch {
  std::vector<Run> runs;
  std::vector<Stream> streams;
  Touch carry = Touch::none;
  Touch latch = Touch::none;
  Touch flag = Touch::none;
  bool acts_where_disabled = false;  ///< whether a step changes enable or memory of disabled pixels
  BitSet reads;                      ///< memory bits read
  BitSet writes;                     ///< memory bits written

  [[nodiscard]] bool empty() const { return runs.empty(); }
  void clear();
};

/// Collects steps clock by clock.
class StepLog {
 public:
  explicit StepLog(PixelBits bits) : bits_(bits) {}

  /// Adds the step of one clock in which `tree` is at the pixels. `tree` is null if the registers in PixelBits hold the
  /// tree bits.
  void push(const ArrayStep& step, const StreamBit* tree);

  [[nodiscard]] const Batch& batch() const { return batch_; }
  void clear() { batch_.clear(); }
  /// Moves the pending batch to `batch` and clears the log.
  void take(Batch& batch) {
    std::swap(batch, batch_);
    batch_.clear();
  }

 private:
  void push_bit(const ArrayStep& step, unsigned bit, const StreamBit* tree, bool latches);
  void append(const Run& run);
  void record_accesses(const Run& run);
  [[nodiscard]] bool is_latch_repeated(const ArrayStep& step) const;
  std::uint16_t find_or_add_stream(const StreamBit& tree);

  PixelBits bits_;
  Batch batch_;
};

}  // namespace csgsim::array
