#include "hw/array/deferred_pixels.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace csgsim::array {

DeferredPixels::DeferredPixels(PlaneShape shape, std::span<const Place> places, PixelBits bits)
    : shape_(shape),
      bits_(bits),
      words_(shape.padded_words() * bits.count()),
      enable_(shape.padded_words()),
      present_(shape.padded_words()),
      log_(bits),
      columns_(shape, places),
      kept_(kept_batches),
      stale_(shape.padded_words() / kernels::block_words),
      since_(stale_.size()),
      on_(stale_.size()) {}

void DeferredPixels::push(const ArrayStep& step, const StreamBit& tree) { push(step, &tree); }

void DeferredPixels::push_with_planes(std::span<const std::uint64_t> tree, const ArrayStep& step) {
  if (step.source == OperandSource::tree && info(step.function).reads_x) store_tree_planes(tree);
  push(step, nullptr);
}

void DeferredPixels::push(const ArrayStep& step, const StreamBit* tree) {
  constexpr std::size_t max_runs = 1024;
  log_.push(step, tree);
  if (log_.batch().runs.size() >= max_runs) settle();
}

/// Overwrites the registers between trees and pixels after all steps that read their old value.
void DeferredPixels::store_tree_planes(std::span<const std::uint64_t> tree) {
  settle_registers();
  if (bits_.tree_bits == 0) allocate_tree_planes(static_cast<unsigned>(tree.size() / enable_.size()));
  for (unsigned bit = 0; bit < bits_.tree_bits; ++bit) {
    const std::span<const std::uint64_t> plane = tree.subspan(bit * enable_.size(), enable_.size());
    for (std::size_t number = 0; number < stale_.size(); ++number)
      std::copy_n(&plane[number * kernels::block_words], kernels::block_words,
                  block(number) + bits_.tree(bit) * kernels::block_words);
  }
}

void DeferredPixels::allocate_tree_planes(unsigned bits) {
  const std::size_t before = bits_.count() * kernels::block_words;
  bits_.tree_bits = bits;
  const std::size_t now = bits_.count() * kernels::block_words;
  Words words(stale_.size() * now);
  for (std::size_t number = 0; number < stale_.size(); ++number)
    std::copy_n(&words_[number * before], before, &words[number * now]);
  words_ = std::move(words);
  log_ = StepLog(bits_);
}

void DeferredPixels::settle() {
  const Batch& batch = log_.batch();
  if (batch.empty()) return;
  select_blocks(batch);
  replay(to_replay_);
  run(batch, to_run_, {});
  const bool sets_any = batch.carry != Touch::none || batch.latch != Touch::none || batch.flag != Touch::none;
  const bool keeps = to_run_.size() < stale_.size() && sets_any;
  for (const std::uint32_t number : to_run_) {
    since_[number] = last_kept_ + (keeps ? 1 : 0);
    if (batch.carry == Touch::sets) stale_[number].carry = 0;
    if (batch.latch == Touch::sets) stale_[number].latch = 0;
    if (batch.flag == Touch::sets) stale_[number].flag = 0;
  }
  if (keeps) keep_batch();
  log_.clear();
}

/// Whether a block without enabled pixels may skip the batch.
bool DeferredPixels::is_skippable(const Batch& batch) {
  return !batch.acts_where_disabled && batch.carry != Touch::uses && batch.latch != Touch::uses &&
         batch.flag != Touch::uses;
}

/// Selects the blocks that execute the batch, and among them those that must first replay skipped batches.
void DeferredPixels::select_blocks(const Batch& batch) {
  kernels::find_ones(enable_.data(), on_);
  const bool may_skip = is_skippable(batch);
  to_run_.clear();
  to_replay_.clear();
  checked_batch_ = 0;
  for (std::uint32_t block = 0; block < stale_.size(); ++block)
    if (!may_skip || on_[block] != 0) add_to_run(block, batch);
}

void DeferredPixels::add_to_run(std::uint32_t block, const Batch& batch) {
  to_run_.push_back(block);
  record_stale_registers(block);
  if (stale_[block].any() && must_replay(batch, stale_[block])) to_replay_.push_back(block);
}

/// Updates the block's record of the last skipped batch that set each register.
void DeferredPixels::record_stale_registers(std::uint32_t block) {
  Stale& stale = stale_[block];
  const std::uint64_t since = since_[block];
  if (last_.carry > since) stale.carry = last_.carry;
  if (last_.latch > since) stale.latch = last_.latch;
  if (last_.flag > since) stale.flag = last_.flag;
  since_[block] = last_kept_;
}

bool DeferredPixels::must_replay(const Batch& batch, const Stale& stale) {
  const auto is_needed = [&](std::uint64_t number, Touch touch) {
    return number != 0 && touch != Touch::sets && (touch == Touch::uses || invalidates(batch, number));
  };
  return is_needed(stale.carry, batch.carry) || is_needed(stale.latch, batch.latch) ||
         is_needed(stale.flag, batch.flag);
}

/// Whether the batch writes memory on which the results of the skipped batch depend.
bool DeferredPixels::invalidates(const Batch& batch, std::uint64_t skipped_batch) {
  if (checked_batch_ == skipped_batch) return is_invalidated_;
  checked_batch_ = skipped_batch;
  is_invalidated_ = batch.writes.intersects(kept_batch(skipped_batch).reads);
  return is_invalidated_;
}

/// Moves the pending batch from the log to the ring.
void DeferredPixels::keep_batch() {
  Batch& kept = kept_[++last_kept_ % kept_batches];
  log_.take(kept);
  if (kept.carry == Touch::sets) last_.carry = last_kept_;
  if (kept.latch == Touch::sets) last_.latch = last_kept_;
  if (kept.flag == Touch::sets) last_.flag = last_kept_;
  if (last_kept_ % (kept_batches / 2) == 0) replay_oldest();
}

/// Replays batches that are about to leave the ring on the blocks that skipped them.
void DeferredPixels::replay_oldest() {
  const std::uint64_t oldest = last_kept_ - std::min(last_kept_, kept_batches / 2);
  const auto is_old = [&](std::uint64_t number) { return number != 0 && number <= oldest; };
  to_replay_.clear();
  for (std::uint32_t block = 0; block < stale_.size(); ++block) {
    record_stale_registers(block);
    if (is_old(stale_[block].carry) || is_old(stale_[block].latch) || is_old(stale_[block].flag))
      to_replay_.push_back(block);
  }
  replay(to_replay_);
}

void DeferredPixels::replay(std::span<const std::uint32_t> blocks) {
  if (blocks.empty()) return;
  replay_register(blocks, &Stale::carry, {.enabled = false, .carry = true, .latch = false, .flag = false});
  replay_register(blocks, &Stale::latch, {.enabled = false, .carry = false, .latch = true, .flag = false});
  replay_register(blocks, &Stale::flag, {.enabled = false, .carry = false, .latch = false, .flag = true});
}

/// Replays each batch once, on all blocks that skipped it.
void DeferredPixels::replay_register(std::span<const std::uint32_t> blocks, std::uint64_t Stale::*register_member,
                                     kernels::Effects effects) {
  for (const std::uint32_t first : blocks) {
    const std::uint64_t number = stale_[first].*register_member;
    if (number == 0) continue;
    same_batch_.clear();
    for (const std::uint32_t block : blocks) {
      if (stale_[block].*register_member != number) continue;
      stale_[block].*register_member = 0;
      same_batch_.push_back(block);
    }
    run(kept_batch(number), same_batch_, effects);
  }
}

void DeferredPixels::run(const Batch& batch, std::span<const std::uint32_t> blocks, kernels::Effects effects) {
  if (blocks.empty()) return;
  effects.has_flag = batch.flag != Touch::none;
  kernels::run(batch.runs, columns_.compute_tables(batch.streams),
               {.bits = words_.data(),
                .stride = bits_.count() * kernels::block_words,
                .enable = enable_.data(),
                .present = present_.data(),
                .row_words = shape_.row_words()},
               blocks, effects);
}

void DeferredPixels::settle_registers() {
  settle();
  for (std::uint32_t block = 0; block < stale_.size(); ++block) record_stale_registers(block);
  to_replay_.resize(stale_.size());
  std::iota(to_replay_.begin(), to_replay_.end(), 0U);
  replay(to_replay_);
}

void DeferredPixels::settle_memory_bit(unsigned address) {
  if (log_.batch().writes.has(bits_.memory(address))) settle();
}

void DeferredPixels::reset() {
  log_.clear();
  clear_stale();
  std::fill(words_.begin(), words_.end(), 0);
}

void DeferredPixels::clear_stale() {
  std::fill(stale_.begin(), stale_.end(), Stale{});
  std::fill(since_.begin(), since_.end(), last_kept_);
}

void DeferredPixels::clear_memory(unsigned address, unsigned bit_count) {
  settle_registers();
  for (std::size_t number = 0; number < stale_.size(); ++number)
    std::fill_n(block(number) + bits_.memory(address) * kernels::block_words, bit_count * kernels::block_words, 0);
}

void DeferredPixels::select_pixels(const Words& present) {
  settle();
  clear_stale();
  for (std::size_t number = 0; number < stale_.size(); ++number)
    std::fill_n(block(number), bits_.memory(0) * kernels::block_words, 0);
  std::fill(enable_.begin(), enable_.end(), 0);
  present_ = present;
}

}  // namespace csgsim::array
