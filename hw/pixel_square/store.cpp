#include "hw/pixel_square/store.h"

#include <algorithm>

#include "hw/pixel_square/figures.h"
#include "hw/systemc/kernel.h"

namespace csgsim::pixel_square {

Store::Store(const machines::Machine& machine)
    : period_(systemc::period_of(machine)), depth_(machines::kind_figures<Figures>(machine).store_words) {}

void Store::begin() {
  words_.clear();
  ends_.clear();
  taken_at_ = 0;
}

void Store::write(const StoredWord& word, std::uint64_t write_edge) {
  words_.push_back({word, write_edge});
  if (word.is_last) ends_.push_back(write_edge);
  if (word.is_last || words_.size() == depth_) notify_after(write_edge);
}

/// Notifies one edge after `edge`. An earlier pending notification is kept; the woken process checks again.
void Store::notify_after(std::uint64_t edge) {
  ready_.notify(sc_core::sc_time::from_value((edge + 1 - this->edge()) * period_.value()));
}

const sc_core::sc_event& Store::ready() {
  if (!ends_.empty()) {
    notify_after(ends_.front());
  } else if (words_.size() == depth_) {
    notify_after(words_.back().edge);
  }
  return ready_;
}

std::uint64_t Store::fill() const {
  const auto is_there = [now = edge()](const Written& word) { return word.edge <= now; };
  return static_cast<std::uint64_t>(std::ranges::count_if(words_, is_there));
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
