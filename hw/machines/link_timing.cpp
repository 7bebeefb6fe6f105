#include "hw/machines/link_timing.h"

#include <algorithm>
#include <utility>

namespace csgsim::machines {

PartAccount part_account(const LinkAccount& account, std::string part_name) {
  return {std::move(part_name),
          {{"sending", account.sending},
           {"blocked", account.blocked},
           {"waiting", account.waiting},
           {"done", account.done}}};
}

LinkTiming::LinkTiming(const Link& link) : link_(link), read_edges_(link.fifo_depth) {}

void LinkTiming::record_request(std::uint64_t edge) {
  account_.waiting += edge + link_.latency - since_;
  since_ = edge + link_.latency;
  sent_ = 0;
  read_ = 0;
  sent_place_ = 0;
  read_place_ = 0;
}

/// The first edge at which the FIFO has room for the next word.
std::uint64_t LinkTiming::room_edge() const { return sent_ < link_.fifo_depth ? 0 : read_edges_[sent_place_] + 1; }

void LinkTiming::store_word(std::uint64_t edge) {
  account_.sending += link_.word_clocks;
  account_.blocked += edge - since_ - link_.word_clocks;
  ++account_.words;
  ++sent_;
  sent_place_ = next_slot(sent_place_);
  since_ = edge;
}

std::uint64_t LinkTiming::send() {
  const std::uint64_t edge = std::max(since_ + link_.word_clocks, room_edge());
  store_word(edge);
  return edge;
}

bool LinkTiming::try_send_before(std::uint64_t edge, std::uint64_t& stored_edge) {
  if (sent_ >= read_ + link_.fifo_depth) return false;
  stored_edge = std::max(since_ + link_.word_clocks, room_edge());
  if (stored_edge >= edge) return false;
  store_word(stored_edge);
  return true;
}

void LinkTiming::read_word(std::uint64_t edge) {
  read_edges_[read_place_] = edge;
  read_place_ = next_slot(read_place_);
  ++read_;
}

void LinkTiming::account_until(std::uint64_t edge, bool words_left) {
  const std::uint64_t clocks = edge - since_;
  since_ = edge;
  if (!words_left) {
    account_.done += clocks;
    return;
  }
  const std::uint64_t sending = std::min<std::uint64_t>(clocks, link_.word_clocks);
  account_.sending += sending;
  account_.blocked += clocks - sending;
}

}  // namespace csgsim::machines
