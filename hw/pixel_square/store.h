#pragma once

#include <cstdint>
#include <deque>
#include <systemc>
#include <utility>

#include "hw/isa/link_word.h"
#include "hw/machines/machine.h"
#include "hw/systemc/kernel.h"

namespace csgsim::pixel_square {

/// An entry of a divider's store: one word of a square's commands, or the mark of an empty square.
struct StoredWord {
  isa::LinkWord word;
  bool is_clear = false;  ///< marks an empty square; `word` is unused
  bool is_last = false;   ///< whether this is the last entry of its square
};

/// The memory between a divider, which writes one word per edge, and the sender, which reads one word per edge. A word
/// written at an edge can be read at the next; an entry freed at an edge can be filled at the next.
class Store {
 public:
  explicit Store(const machines::Machine& machine);

  void begin();

  // Interface to the divider.
  [[nodiscard]] bool has_room() const { return words_.size() + (taken_at_ == edge() ? 1U : 0U) < depth_; }
  /// Whether room at the next edge is guaranteed; valid only if there is no room at this edge.
  [[nodiscard]] bool has_room_next() const { return words_.size() < depth_; }
  /// Writes a word that becomes visible after this edge.
  void write(const StoredWord& word) { write(word, edge()); }
  /// Writes a word that becomes visible after the later edge `write_edge`; requires guaranteed room for the word.
  void write(const StoredWord& word, std::uint64_t write_edge);
  /// Whether room for `words` words is guaranteed from the next edge on.
  [[nodiscard]] bool has_room_for(std::uint64_t words) const { return words_.size() + words <= depth_; }
  /// Notified when there will be room at the next edge.
  [[nodiscard]] const sc_core::sc_event& freed() const { return freed_; }

  // Interface to the sender.
  /// Whether sending of a square can begin: the square is complete, or the store is full.
  [[nodiscard]] bool may_begin() const;
  /// Oldest word; null if no stored word was written at an earlier edge.
  [[nodiscard]] const StoredWord* front() const;
  /// Removes the oldest word; front() must not be null.
  void take();
  /// Event at which sending of a square may become possible; valid while no square can begin.
  [[nodiscard]] const sc_core::sc_event& ready();

  /// Number of stored words.
  [[nodiscard]] std::uint64_t fill() const;

 private:
  struct Written {
    StoredWord word;
    std::uint64_t edge;
  };

  [[nodiscard]] std::uint64_t edge() const { return systemc::edges(period_); }
  void notify_after(std::uint64_t edge);

  const sc_core::sc_time period_;
  const std::uint64_t depth_;
  std::deque<Written> words_;
  std::deque<std::uint64_t> ends_;  ///< edges at which the last words of the stored squares were written
  std::uint64_t taken_at_ = 0;      ///< clock edge
  sc_core::sc_event freed_;
  sc_core::sc_event ready_;
};

}  // namespace csgsim::pixel_square
