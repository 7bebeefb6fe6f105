#include "hw/pixel_square/store.h"

#include "hw/pixel_square/figures.h"
#include "hw/systemc/kernel.h"

namespace csgsim::pixel_square {

Store::Store(const machines::Machine& machine)
    : period_(systemc::period_of(machine)), depth_(machines::own<Figures>(machine).store_words) {}

void Store::begin() {
  words_.clear();
  ends_.clear();
  taken_at_ = 0;
}

void Store::write(const StoredWord& word) {
  words_.push_back({word, edge()});
  if (word.is_last) ends_.push_back(edge());
}

bool Store::may_begin() const {
  if (!ends_.empty() && ends_.front() < edge()) return true;
  return words_.size() == depth_ && words_.back().edge < edge();
}

const StoredWord* Store::front() const {
  return words_.empty() || words_.front().edge >= edge() ? nullptr : &words_.front().word;
}

void Store::take() {
  if (words_.front().word.is_last) ends_.pop_front();
  words_.pop_front();
  taken_at_ = edge();
  freed_.notify(sc_core::SC_ZERO_TIME);
}

}  // namespace csgsim::pixel_square
