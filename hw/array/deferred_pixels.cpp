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
      owed_(shape.padded_words() / kernels::block_words),
      on_(owed_.size()) {}

void DeferredPixels::push(const ArrayStep& step, const StreamBit& tree) { push(step, &tree); }

void DeferredPixels::push_with(std::span<const std::uint64_t> tree, const ArrayStep& step) {
  if (step.source == OperandSource::tree && info(step.function).reads_x) put_tree(tree);
  push(step, nullptr);
}

void DeferredPixels::push(const ArrayStep& step, const StreamBit* tree) {
  constexpr std::size_t most_runs = 1024;
  log_.push(step, tree);
  if (log_.batch().runs.size() >= most_runs) settle();
}

/// What the registers had is needed no more then.
void DeferredPixels::put_tree(std::span<const std::uint64_t> tree) {
  settle_registers();
  if (bits_.tree_bits == 0) add_tree(static_cast<unsigned>(tree.size() / enable_.size()));
  for (unsigned bit = 0; bit < bits_.tree_bits; ++bit) {
    const std::span<const std::uint64_t> plane = tree.subspan(bit * enable_.size(), enable_.size());
    for (std::size_t number = 0; number < owed_.size(); ++number)
      std::copy_n(&plane[number * kernels::block_words], kernels::block_words,
                  block(number) + bits_.tree(bit) * kernels::block_words);
  }
}

void DeferredPixels::add_tree(unsigned bits) {
  const std::size_t before = bits_.count() * kernels::block_words;
  bits_.tree_bits = bits;
  const std::size_t now = bits_.count() * kernels::block_words;
  Words words(owed_.size() * now);
  for (std::size_t number = 0; number < owed_.size(); ++number)
    std::copy_n(&words_[number * before], before, &words[number * now]);
  words_ = std::move(words);
  log_ = StepLog(bits_);
}

void DeferredPixels::settle() {
  const Batch& batch = log_.batch();
  if (batch.empty()) return;
  choose(batch, last_kept_ + 1);
  pay(to_pay_);
  run(batch, to_run_, {});
  for (const std::uint32_t number : to_run_) {
    if (batch.carry == Touch::sets) owed_[number].carry = 0;
    if (batch.latch == Touch::sets) owed_[number].latch = 0;
    if (batch.flag == Touch::sets) owed_[number].flag = 0;
  }
  const bool sets_any = batch.carry != Touch::none || batch.latch != Touch::none || batch.flag != Touch::none;
  if (to_run_.size() < owed_.size() && sets_any) keep(batch);
  log_.clear();
}

/// A block that has no pixel enabled need not carry the batch out.
bool DeferredPixels::may_be_left_out(const Batch& batch) {
  return !batch.acts_where_disabled && batch.carry != Touch::uses && batch.latch != Touch::uses &&
         batch.flag != Touch::uses;
}

/// Sorts the blocks into those that carry the batch out, some of them after what they owe, and the others.
void DeferredPixels::choose(const Batch& batch, std::uint64_t number) {
  kernels::find_ones(enable_.data(), on_);
  const bool leaves_out = may_be_left_out(batch);
  to_run_.clear();
  to_pay_.clear();
  asked_about_ = 0;
  for (std::uint32_t block = 0; block < owed_.size(); ++block) {
    Owed& owed = owed_[block];
    if (leaves_out && on_[block] == 0) {
      if (batch.carry == Touch::sets) owed.carry = number;
      if (batch.latch == Touch::sets) owed.latch = number;
      if (batch.flag == Touch::sets) owed.flag = number;
    } else {
      to_run_.push_back(block);
      if (owed.any() && needs(batch, owed)) to_pay_.push_back(block);
    }
  }
}

bool DeferredPixels::needs(const Batch& batch, const Owed& owed) {
  const auto is_needed = [&](std::uint64_t number, Touch touch) {
    return number != 0 && touch != Touch::sets && (touch == Touch::uses || spoils(batch, number));
  };
  return is_needed(owed.carry, batch.carry) || is_needed(owed.latch, batch.latch) || is_needed(owed.flag, batch.flag);
}

/// The batch writes memory that what is owed depends on.
bool DeferredPixels::spoils(const Batch& batch, std::uint64_t owed) {
  if (asked_about_ == owed) return spoiled_;
  asked_about_ = owed;
  const std::vector<BitRange>& reads = kept(owed).reads;
  spoiled_ = std::any_of(reads.begin(), reads.end(), [&](BitRange range) { return batch.writes_any(range); });
  return spoiled_;
}

/// Blocks that still owe what is about to be forgotten make up for it.
void DeferredPixels::keep(const Batch& batch) {
  kept_[++last_kept_ % kept_batches] = batch;
  constexpr std::uint64_t check_every = kept_batches / 2;
  if (last_kept_ % check_every != 0) return;
  const std::uint64_t oldest = last_kept_ - std::min(last_kept_, check_every);
  const auto is_old = [&](std::uint64_t number) { return number != 0 && number <= oldest; };
  to_pay_.clear();
  for (std::uint32_t block = 0; block < owed_.size(); ++block)
    if (is_old(owed_[block].carry) || is_old(owed_[block].latch) || is_old(owed_[block].flag)) to_pay_.push_back(block);
  pay(to_pay_);
}

void DeferredPixels::pay(std::span<const std::uint32_t> blocks) {
  if (blocks.empty()) return;
  pay_one(blocks, &Owed::carry, {.enabled = false, .carry = true, .latch = false, .flag = false});
  pay_one(blocks, &Owed::latch, {.enabled = false, .carry = false, .latch = true, .flag = false});
  pay_one(blocks, &Owed::flag, {.enabled = false, .carry = false, .latch = false, .flag = true});
}

/// A batch after another, each on all blocks that owe it.
void DeferredPixels::pay_one(std::span<const std::uint32_t> blocks, std::uint64_t Owed::*what,
                             kernels::Effects effects) {
  for (const std::uint32_t first : blocks) {
    const std::uint64_t number = owed_[first].*what;
    if (number == 0) continue;
    same_.clear();
    for (const std::uint32_t block : blocks) {
      if (owed_[block].*what != number) continue;
      owed_[block].*what = 0;
      same_.push_back(block);
    }
    run(kept(number), same_, effects);
  }
}

void DeferredPixels::run(const Batch& batch, std::span<const std::uint32_t> blocks, kernels::Effects effects) {
  if (blocks.empty()) return;
  effects.has_flag = batch.flag != Touch::none;
  kernels::run(batch.runs, columns_.of(batch.streams),
               {.bits = words_.data(),
                .stride = bits_.count() * kernels::block_words,
                .enable = enable_.data(),
                .present = present_.data(),
                .row_words = shape_.row_words()},
               blocks, effects);
}

void DeferredPixels::settle_registers() {
  settle();
  to_pay_.resize(owed_.size());
  std::iota(to_pay_.begin(), to_pay_.end(), 0U);
  pay(to_pay_);
}

void DeferredPixels::settle_memory(unsigned address) {
  const unsigned bit = bits_.memory(address);
  if (log_.batch().writes_any({bit, bit + 1})) settle();
}

void DeferredPixels::reset() {
  log_.clear();
  std::fill(owed_.begin(), owed_.end(), Owed{});
  std::fill(words_.begin(), words_.end(), 0);
}

void DeferredPixels::clear_memory(unsigned address, unsigned count) {
  settle_registers();
  for (std::size_t number = 0; number < owed_.size(); ++number)
    std::fill_n(block(number) + bits_.memory(address) * kernels::block_words, count * kernels::block_words, 0);
}

void DeferredPixels::select(const Words& present) {
  settle();
  std::fill(owed_.begin(), owed_.end(), Owed{});
  for (std::size_t number = 0; number < owed_.size(); ++number)
    std::fill_n(block(number), bits_.memory(0) * kernels::block_words, 0);
  std::fill(enable_.begin(), enable_.end(), 0);
  present_ = present;
}

}  // namespace csgsim::array
