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
      since_(owed_.size()),
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
  choose(batch);
  pay(to_pay_);
  run(batch, to_run_, {});
  const bool sets_any = batch.carry != Touch::none || batch.latch != Touch::none || batch.flag != Touch::none;
  const bool keeps = to_run_.size() < owed_.size() && sets_any;
  for (const std::uint32_t number : to_run_) {
    since_[number] = last_kept_ + (keeps ? 1 : 0);
    if (batch.carry == Touch::sets) owed_[number].carry = 0;
    if (batch.latch == Touch::sets) owed_[number].latch = 0;
    if (batch.flag == Touch::sets) owed_[number].flag = 0;
  }
  if (keeps) keep();
  log_.clear();
}

/// A block that has no pixel enabled need not carry the batch out.
bool DeferredPixels::may_be_left_out(const Batch& batch) {
  return !batch.acts_where_disabled && batch.carry != Touch::uses && batch.latch != Touch::uses &&
         batch.flag != Touch::uses;
}

/// The blocks that carry the batch out, and those of them that have to do before what they owe.
void DeferredPixels::choose(const Batch& batch) {
  kernels::find_ones(enable_.data(), on_);
  const bool leaves_out = may_be_left_out(batch);
  to_run_.clear();
  to_pay_.clear();
  asked_about_ = 0;
  for (std::uint32_t block = 0; block < owed_.size(); ++block)
    if (!leaves_out || on_[block] != 0) add_to_run(block, batch);
}

void DeferredPixels::add_to_run(std::uint32_t block, const Batch& batch) {
  to_run_.push_back(block);
  note_owed(block);
  if (owed_[block].any() && needs(batch, owed_[block])) to_pay_.push_back(block);
}

/// What it has left out since it was looked at last: of each register, the last batch that set it.
void DeferredPixels::note_owed(std::uint32_t block) {
  Owed& owed = owed_[block];
  const std::uint64_t since = since_[block];
  if (last_.carry > since) owed.carry = last_.carry;
  if (last_.latch > since) owed.latch = last_.latch;
  if (last_.flag > since) owed.flag = last_.flag;
  since_[block] = last_kept_;
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
  spoiled_ = batch.writes.meets(kept(owed).reads);
  return spoiled_;
}

/// The batch at hand, which the log forgets.
void DeferredPixels::keep() {
  Batch& kept = kept_[++last_kept_ % kept_batches];
  log_.take(kept);
  if (kept.carry == Touch::sets) last_.carry = last_kept_;
  if (kept.latch == Touch::sets) last_.latch = last_kept_;
  if (kept.flag == Touch::sets) last_.flag = last_kept_;
  if (last_kept_ % (kept_batches / 2) == 0) pay_old();
}

/// Blocks that still owe what is about to be forgotten make up for it.
void DeferredPixels::pay_old() {
  const std::uint64_t oldest = last_kept_ - std::min(last_kept_, kept_batches / 2);
  const auto is_old = [&](std::uint64_t number) { return number != 0 && number <= oldest; };
  to_pay_.clear();
  for (std::uint32_t block = 0; block < owed_.size(); ++block) {
    note_owed(block);
    if (is_old(owed_[block].carry) || is_old(owed_[block].latch) || is_old(owed_[block].flag)) to_pay_.push_back(block);
  }
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
  for (std::uint32_t block = 0; block < owed_.size(); ++block) note_owed(block);
  to_pay_.resize(owed_.size());
  std::iota(to_pay_.begin(), to_pay_.end(), 0U);
  pay(to_pay_);
}

void DeferredPixels::settle_memory(unsigned address) {
  if (log_.batch().writes.has(bits_.memory(address))) settle();
}

void DeferredPixels::reset() {
  log_.clear();
  forget_owed();
  std::fill(words_.begin(), words_.end(), 0);
}

void DeferredPixels::forget_owed() {
  std::fill(owed_.begin(), owed_.end(), Owed{});
  std::fill(since_.begin(), since_.end(), last_kept_);
}

void DeferredPixels::clear_memory(unsigned address, unsigned count) {
  settle_registers();
  for (std::size_t number = 0; number < owed_.size(); ++number)
    std::fill_n(block(number) + bits_.memory(address) * kernels::block_words, count * kernels::block_words, 0);
}

void DeferredPixels::select(const Words& present) {
  settle();
  forget_owed();
  for (std::size_t number = 0; number < owed_.size(); ++number)
    std::fill_n(block(number), bits_.memory(0) * kernels::block_words, 0);
  std::fill(enable_.begin(), enable_.end(), 0);
  present_ = present;
}

}  // namespace csgsim::array
