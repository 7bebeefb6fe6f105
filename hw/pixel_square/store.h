#pragma once

#include <cstdint>
#include <deque>
#include <systemc>
#include <utility>

#include "hw/isa/link_word.h"
#include "hw/machines/machine.h"
#include "hw/systemc/kernel.h"

namespace csgsim::pixel_square {

/// What a divider stores of a square: its commands word by word, or that nothing is seen in it.
struct StoredWord {
  isa::LinkWord word;
  bool is_clear = false;  ///< no word, but all of a square in which nothing is seen
  bool is_last = false;   ///< of its square
};

/// The memory between a divider, which writes a word at an edge, and what sends the squares, which takes one. A word
/// written at an edge can be taken at the next; a place freed at an edge can be filled at the next.
class Store {
 public:
  explicit Store(const machines::Machine& machine);

  void begin();

  // The divider's end.
  [[nodiscard]] bool has_room() const { return words_.size() + (taken_at_ == edge() ? 1U : 0U) < depth_; }
  /// Without room at this edge, whether there is some at the next whatever happens.
  [[nodiscard]] bool room_follows() const { return words_.size() < depth_; }
  /// From this edge on.
  void write(const StoredWord& word) { write(word, edge()); }
  /// From a later edge on; there has to be room for it whatever happens.
  void write(const StoredWord& word, std::uint64_t edge);
  /// Whether there is room for so many at any edge from the next on, whatever happens.
  [[nodiscard]] bool has_room_for(std::uint64_t words) const { return words_.size() + words <= depth_; }
  /// Happens when there will be room at the next edge.
  [[nodiscard]] const sc_core::sc_event& freed() const { return freed_; }

  // The sender's end.
  /// Whether a square can be begun: it is whole, or there is no room for more of it.
  [[nodiscard]] bool may_begin() const;
  /// Null if none has been written at an earlier edge.
  [[nodiscard]] const StoredWord* front() const;
  void take();
  /// While no square can be begun: happens at an edge at which one may be.
  [[nodiscard]] const sc_core::sc_event& ready();

  [[nodiscard]] std::uint64_t fill() const;

 private:
  struct Written {
    StoredWord word;
    std::uint64_t edge;
  };

  [[nodiscard]] std::uint64_t edge() const { return systemc::edges(period_); }
  void tell_after(std::uint64_t edge);

  const sc_core::sc_time period_;
  const std::uint64_t depth_;
  std::deque<Written> words_;
  std::deque<std::uint64_t> ends_;  ///< edges at which the last words of squares were written that are there
  std::uint64_t taken_at_ = 0;      ///< edge
  sc_core::sc_event freed_;
  sc_core::sc_event ready_;
};

}  // namespace csgsim::pixel_square
