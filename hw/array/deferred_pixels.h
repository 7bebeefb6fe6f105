#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/array/column_bits.h"
#include "hw/array/kernels.h"
#include "hw/array/plane.h"
#include "hw/array/step_log.h"

namespace csgsim::array {

/// The bits of all pixels, and steps that they have still to carry out, which they do when somebody is to look: many
/// clocks of a block of pixels at a time.
///
/// Where no pixel of a block is enabled, steps that then change neither memory nor enable are not carried out, if what
/// they leave in carry, latch and flag depends on the memory alone. The block owes that, and makes up for it when
/// somebody is to look at it, when steps need it, and before the memory that it depends on changes.
class DeferredPixels {
 public:
  DeferredPixels(PlaneShape shape, std::span<const Place> places, PixelBits bits);

  /// One clock.
  void push(const ArrayStep& step, const StreamBit& tree);
  /// One in which the registers between trees and pixels have those bits, a plane of the first of them and so on,
  /// always as many; they are asked for only where the step takes them.
  void push_with(std::span<const std::uint64_t> tree, const ArrayStep& step);

  /// Afterwards memory and enable are as the steps so far leave them.
  void settle();
  /// Carry, latch and flag too.
  void settle_registers();
  /// Afterwards that memory bit is.
  void settle_memory(unsigned address);

  /// Forgets the steps that have not been carried out, and clears memory.
  void reset();
  void clear_memory(unsigned address, unsigned count);
  /// Clears the registers; `present` are then the pixels that take part.
  void select(const Words& present);

  // What has been settled. `bit` is one of bits().
  [[nodiscard]] const PixelBits& bits() const { return bits_; }
  [[nodiscard]] const Words& enable() const { return enable_; }
  [[nodiscard]] std::uint64_t word(unsigned bit, std::size_t word) const {
    return words_[(word / kernels::block_words * bits_.count() + bit) * kernels::block_words +
                  word % kernels::block_words];
  }

 private:
  /// The last batch whose carry, latch or flag a block has left out. A number says which; 0 is none.
  struct Owed {
    std::uint64_t carry = 0;
    std::uint64_t latch = 0;
    std::uint64_t flag = 0;

    [[nodiscard]] bool any() const { return (carry | latch | flag) != 0; }
  };

  static constexpr std::uint64_t kept_batches = 64;

  [[nodiscard]] std::uint64_t* block(std::size_t number) {
    return &words_[number * bits_.count() * kernels::block_words];
  }
  [[nodiscard]] const Batch& kept(std::uint64_t number) const { return kept_[number % kept_batches]; }
  [[nodiscard]] static bool may_be_left_out(const Batch& batch);
  [[nodiscard]] bool needs(const Batch& batch, const Owed& owed);
  [[nodiscard]] bool spoils(const Batch& batch, std::uint64_t owed);
  void choose(const Batch& batch);
  void add_to_run(std::uint32_t block, const Batch& batch);
  void note_owed(std::uint32_t block);
  void keep();
  void pay_old();
  void forget_owed();
  void pay(std::span<const std::uint32_t> blocks);
  void pay_one(std::span<const std::uint32_t> blocks, std::uint64_t Owed::*what, kernels::Effects effects);
  void put_tree(std::span<const std::uint64_t> tree);
  void add_tree(unsigned bits);
  void push(const ArrayStep& step, const StreamBit* tree);
  void run(const Batch& batch, std::span<const std::uint32_t> blocks, kernels::Effects effects);

  PlaneShape shape_;
  PixelBits bits_;
  Words words_;  ///< a block of pixels after another, and in each of these a bit of PixelBits after another
  Words enable_;
  Words present_;
  StepLog log_;
  ColumnBits columns_;
  std::vector<Batch> kept_;      ///< a ring: what blocks may owe
  std::uint64_t last_kept_ = 0;  ///< its number
  Owed last_;                    ///< the last kept batches that set the registers
  std::vector<Owed> owed_;       ///< by block, of the batches up to that in since_: those after it it has left out
  std::vector<std::uint64_t> since_;
  std::vector<std::uint8_t> on_;  ///< by block: some pixel is enabled
  std::vector<std::uint32_t> to_run_;
  std::vector<std::uint32_t> to_pay_;
  std::vector<std::uint32_t> same_;  ///< blocks that owe the same
  std::uint64_t asked_about_ = 0;    ///< what `spoils` was asked about last
  bool spoiled_ = false;             ///< and its answer
};

}  // namespace csgsim::array
