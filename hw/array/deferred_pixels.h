// Deferred, batched execution of pixel processors.
// Used by PixelArray.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/array/column_bits.h"
#include "hw/array/kernels.h"
#include "hw/array/plane.h"
#include "hw/array/step_log.h"

namespace csgsim::array {

/// The bits of all pixels, with deferred execution: steps are queued, and executed in batches when a result is read,
/// block by block of pixels.
///
/// A block without enabled pixels skips a batch that changes neither memory nor enable bits of disabled pixels,
/// provided that the values which the batch leaves in carry, latch and flag depend only on memory. These registers of
/// the block are then stale. The batch is replayed on the block before its registers are read, before a step uses them,
/// and before the memory on which they depend changes.
class DeferredPixels {
 public:
  DeferredPixels(PlaneShape shape, std::span<const Place> places, PixelBits bits);

  /// Queues the step of one clock.
  void push(const ArrayStep& step, const StreamBit& tree);
  /// Queues the step of one clock. `tree` holds the bit planes in the registers between trees and pixels, lowest bit
  /// first; the number of planes must be the same in all calls.
  void push_with_planes(std::span<const std::uint64_t> tree, const ArrayStep& step);

  /// Executes pending steps, so that memory and enable are up to date.
  void settle();
  /// Brings carry, latch and flag up to date as well.
  void settle_registers();
  /// Brings one memory bit of all pixels up to date.
  void settle_memory_bit(unsigned address);

  /// Discards pending steps and clears memory.
  void reset();
  void clear_memory(unsigned address, unsigned bit_count);
  /// Clears the registers. The pixels in `present` take part in all later steps; the others stay disabled.
  void select_pixels(const Words& present);

  // State without the effects of pending steps; settle() executes these. `bit_index` is an index as in bits().
  [[nodiscard]] const PixelBits& bits() const { return bits_; }
  [[nodiscard]] const Words& enable() const { return enable_; }
  [[nodiscard]] std::uint64_t word(unsigned bit_index, std::size_t word_index) const {
    return words_[(word_index / kernels::block_words * bits_.count() + bit_index) * kernels::block_words +
                  word_index % kernels::block_words];
  }

 private:
  /// For one block and each register: number of the last skipped batch that wrote the register; 0 if the register is
  /// up to date.
  struct Stale {
    std::uint64_t carry = 0;
    std::uint64_t latch = 0;
    std::uint64_t flag = 0;

    [[nodiscard]] bool any() const { return (carry | latch | flag) != 0; }
  };

  static constexpr std::uint64_t kept_batches = 64;

  [[nodiscard]] std::uint64_t* block(std::size_t block_number) {
    return &words_[block_number * bits_.count() * kernels::block_words];
  }
  [[nodiscard]] const Batch& kept_batch(std::uint64_t batch_number) const { return kept_[batch_number % kept_batches]; }
  [[nodiscard]] static bool is_skippable(const Batch& batch);
  [[nodiscard]] bool must_replay(const Batch& batch, const Stale& stale);
  [[nodiscard]] bool invalidates(const Batch& batch, std::uint64_t skipped_batch);
  void select_blocks(const Batch& batch);
  void add_to_run(std::uint32_t block, const Batch& batch);
  void record_stale_registers(std::uint32_t block);
  void keep_batch();
  void replay_oldest();
  void clear_stale();
  void replay(std::span<const std::uint32_t> blocks);
  void replay_register(std::span<const std::uint32_t> blocks, std::uint64_t Stale::*register_member,
                       kernels::Effects effects);
  void store_tree_planes(std::span<const std::uint64_t> tree);
  void allocate_tree_planes(unsigned bits);
  void push(const ArrayStep& step, const StreamBit* tree);
  void run(const Batch& batch, std::span<const std::uint32_t> blocks, kernels::Effects effects);

  PlaneShape shape_;
  PixelBits bits_;
  Words words_;  ///< block after block of pixels; within a block, one bit of PixelBits after another
  Words enable_;
  Words present_;
  StepLog log_;
  ColumnBits columns_;
  std::vector<Batch> kept_;      ///< ring of batches that some blocks have skipped
  std::uint64_t last_kept_ = 0;  ///< number of the last kept batch
  Stale last_;                   ///< last kept batches that set each register
  /// Stale registers of each block up to batch since_ of the block, which has skipped all later batches.
  std::vector<Stale> stale_;
  std::vector<std::uint64_t> since_;
  std::vector<std::uint8_t> on_;  ///< per block: whether any pixel is enabled
  std::vector<std::uint32_t> to_run_;
  std::vector<std::uint32_t> to_replay_;
  std::vector<std::uint32_t> same_batch_;  ///< blocks that replay the same batch
  std::uint64_t checked_batch_ = 0;        ///< batch of the last call of `invalidates`
  bool is_invalidated_ = false;            ///< result of that call
};

}  // namespace csgsim::array
