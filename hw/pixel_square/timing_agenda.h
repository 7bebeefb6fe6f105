#pragma once

#include <algorithm>
#include <bit>
#include <boost/circular_buffer.hpp>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "hw/pixel_square/account.h"

/// Event-driven timing: units act only at the clock edges at which their state can change.
namespace csgsim::pixel_square {

/// Number of a clock edge, counted from 1.
using Time = std::uint64_t;

/// Numbers of the units in the agenda. At each edge, units act in the order of their numbers. Pixels act before their
/// decoder, because the decoder can take a word at the edge at which the pixels take a command; graphics processors act
/// in their own order. For the other units the order has no effect.
struct PartNumbers {
  std::size_t renderers = 1;
  std::size_t dividers = 0;
  std::size_t processors = 0;

  [[nodiscard]] std::size_t pixels(std::size_t renderer) const { return renderer; }
  [[nodiscard]] std::size_t decoder(std::size_t renderer) const { return renderers + renderer; }
  [[nodiscard]] std::size_t output(std::size_t renderer) const { return 2 * renderers + renderer; }
  [[nodiscard]] std::size_t sender() const { return 3 * renderers; }
  [[nodiscard]] std::size_t frame_buffer() const { return sender() + 1; }
  [[nodiscard]] std::size_t ring() const { return frame_buffer() + 1; }
  [[nodiscard]] std::size_t divider(std::size_t number) const { return ring() + 1 + number; }
  [[nodiscard]] std::size_t processor(std::size_t number) const { return divider(dividers) + number; }
  [[nodiscard]] std::size_t count() const { return processor(processors); }
};

/// Round-robin successor of `number`, modulo `count`.
constexpr std::size_t next_in_turn(std::size_t number, std::size_t count) {
  return number + 1 == count ? 0 : number + 1;
}

/// Set of indices below a bound.
class IndexSet {
 public:
  explicit IndexSet(std::size_t count) : words_((count + 63) / 64) {}

  [[nodiscard]] bool empty() const {
    return std::ranges::all_of(words_, [](std::uint64_t word) { return word == 0; });
  }
  void add(std::size_t number) { words_[number / 64] |= bit(number); }
  void remove(std::size_t number) { words_[number / 64] &= ~bit(number); }

  /// Removes and returns the smallest element, if any.
  std::optional<std::size_t> take() {
    for (std::size_t i = 0; i < words_.size(); ++i) {
      const std::uint64_t word = words_[i];
      if (word == 0) continue;
      words_[i] = word & (word - 1);
      return i * 64 + static_cast<std::size_t>(std::countr_zero(word));
    }
    return std::nullopt;
  }

  /// Calls `visit` with each element, in cyclic order from `first` on, until it returns false. `visit` may add or
  /// remove only the element it is called with.
  template <class Visit>
  void for_each_from(std::size_t first, const Visit& visit) const {
    if (words_.empty()) return;
    const std::uint64_t before_first = bit(first) - 1;
    if (!visit_word(first / 64, ~before_first, visit)) return;
    for (std::size_t i = 1; i < words_.size(); ++i)
      if (!visit_word((first / 64 + i) % words_.size(), ~std::uint64_t{0}, visit)) return;
    visit_word(first / 64, before_first, visit);
  }

 private:
  static constexpr std::uint64_t bit(std::size_t number) { return std::uint64_t{1} << number % 64; }

  template <class Visit>
  bool visit_word(std::size_t word, std::uint64_t mask, const Visit& visit) const {
    for (std::uint64_t left = words_[word] & mask; left != 0; left &= left - 1)
      if (!visit(word * 64 + static_cast<std::size_t>(std::countr_zero(left)))) return false;
    return true;
  }

  std::vector<std::uint64_t> words_;
};

/// Schedule of the units' next edges. A waiting unit sleeps until another unit wakes it. Most units act again at the
/// next edge, so the units of this edge and the next are bit sets; the others are in a heap.
class Agenda {
 public:
  explicit Agenda(std::size_t parts) : due_(parts, never), this_edge_(parts), next_edge_(parts) {}

  /// Schedules the unit for `edge`, the current edge or a later one, and discards its previous entry.
  void schedule(std::size_t part, Time edge) {
    due_[part] = edge;
    if (edge == now_) {
      this_edge_.add(part);
    } else if (edge == now_ + 1) {
      next_edge_.add(part);
    } else {
      later_.emplace(edge, part);
    }
  }

  /// Schedules the unit for `edge` if it sleeps; otherwise keeps its entry.
  void wake(std::size_t part, Time edge) {
    if (due_[part] == never) schedule(part, edge);
  }

  /// Returns the next unit to act and its edge. The unit then sleeps until it is scheduled again.
  std::pair<Time, std::size_t> next() {
    for (;;) {
      const std::optional<std::size_t> part = this_edge_.take();
      if (!part) {
        advance();
      } else if (due_[*part] == now_) {
        due_[*part] = never;
        return {now_, *part};
      }
    }
  }

 private:
  static constexpr Time never = ~Time{0};

  /// Advances to the next edge at which a unit acts.
  void advance() {
    now_ = next_edge_.empty() ? later_.top().first : now_ + 1;
    std::swap(this_edge_, next_edge_);
    for (; !later_.empty() && later_.top().first == now_; later_.pop()) this_edge_.add(later_.top().second);
  }

  using Entry = std::pair<Time, std::size_t>;
  Time now_ = 0;
  std::vector<Time> due_;  ///< next edge of each unit; `never` while it sleeps
  IndexSet this_edge_;
  IndexSet next_edge_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> later_;
};

/// A FIFO between two units. Writing wakes its reader, and reading wakes its writer.
template <class Word>
class Fifo {
 public:
  Fifo(std::size_t depth, std::size_t writer, std::size_t reader, Agenda& agenda)
      : depth_(depth), writer_(writer), reader_(reader), agenda_(&agenda) {}

  [[nodiscard]] bool has_word(Time now) const { return !words_.empty() && words_.front().second < now; }
  [[nodiscard]] bool has_room(Time now) const { return words_.size() + (read_ == now ? 1U : 0U) < depth_; }

  // State at the next edge without further reads and writes; valid only if there is no word, or no room, at this edge.
  [[nodiscard]] bool has_word_next() const { return !words_.empty(); }
  [[nodiscard]] bool has_room_next() const { return words_.size() < depth_; }

  [[nodiscard]] const Word& oldest() const { return words_.front().first; }

  /// Keeps `number` in `with_words` while the FIFO is not empty.
  void track_in(IndexSet& with_words, std::size_t number) {
    with_words_ = &with_words;
    number_ = number;
  }

  void write(Time now, Word word) {
    if (words_.full()) words_.set_capacity(std::max<std::size_t>(2 * words_.size(), 8));
    words_.push_back({std::move(word), now});
    if (with_words_ != nullptr) with_words_->add(number_);
    agenda_->wake(reader_, now + 1);
  }

  Word read(Time now) {
    const Word word = words_.front().first;
    words_.pop_front();
    if (with_words_ != nullptr && words_.empty()) with_words_->remove(number_);
    read_ = now;
    agenda_->wake(writer_, now + 1);
    return word;
  }

 private:
  std::size_t depth_;
  std::size_t writer_;
  std::size_t reader_;
  Agenda* agenda_;
  boost::circular_buffer<std::pair<Word, Time>> words_;  ///< words, each with the edge at which it was written
  Time read_ = 0;                                        ///< edge of the last read
  IndexSet* with_words_ = nullptr;
  std::size_t number_ = 0;
};

/// Clocks of a unit by activity, counted in chronological order.
class PartClocks {
 public:
  /// Counts the next `clocks` clocks as working.
  void count_working(Time clocks) { add(SquareActivity::working, clocks); }

  /// Attributes all clocks before `now` that have not been counted to `activity`.
  void count_waiting(SquareActivity activity, Time now) { add(activity, now - next_clock_); }

  /// Completes the account; `end` is the frame's last clock.
  [[nodiscard]] const SquareClocks& complete(Time end) {
    count_waiting(SquareActivity::done, end + 1);
    return clocks_;
  }

 private:
  void add(SquareActivity activity, Time clocks) {
    clocks_.add(activity, clocks);
    next_clock_ += clocks;
  }

  SquareClocks clocks_;
  Time next_clock_ = 1;
};

}  // namespace csgsim::pixel_square
