#pragma once

#include <deque>
#include <optional>

#include "hw/pixel_square/timing_agenda.h"
#include "hw/pixel_square/timing_renderer.h"

namespace csgsim::pixel_square {

/// A word stored by a divider.
struct TimedStored {
  std::optional<TimedCommand> whole;  ///< set in the last word of a command
  bool is_last = false;               ///< last word of its square
};

/// Edge-level model of a divider's store.
class StoreTiming {
 public:
  StoreTiming(std::size_t depth, std::size_t divider, std::size_t sender, Agenda& agenda)
      : depth_(depth), words_(depth, divider, sender, agenda) {}

  void write(Time now, const TimedStored& word) {
    words_.write(now, word);
    ++filled_;
    written_ = now;
    if (word.is_last) ends_.push_back(now);
  }
  TimedStored read(Time now) {
    TimedStored word = words_.read(now);
    --filled_;
    if (word.is_last) ends_.pop_front();
    return word;
  }

  [[nodiscard]] bool has_room(Time now) const { return words_.has_room(now); }
  [[nodiscard]] bool has_room_next() const { return words_.has_room_next(); }
  [[nodiscard]] bool has_word(Time now) const { return words_.has_word(now); }
  [[nodiscard]] bool has_word_next() const { return words_.has_word_next(); }

  /// Whether sending of a square can begin: the square is complete, or the store is full.
  [[nodiscard]] bool may_begin(Time now) const {
    return (!ends_.empty() && ends_.front() < now) || (filled_ == depth_ && written_ < now);
  }

 private:
  std::size_t depth_;
  std::size_t filled_ = 0;
  Time written_ = 0;       ///< edge of the last word
  std::deque<Time> ends_;  ///< edges at which the last words of the stored squares were written
  Fifo<TimedStored> words_;
};

}  // namespace csgsim::pixel_square
