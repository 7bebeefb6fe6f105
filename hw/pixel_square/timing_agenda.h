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

/// What the clocks of a frame are worked out with, from edge to edge at which something happens. Every part acts at
/// edges, on what the edges before have left.
namespace csgsim::pixel_square {

/// Number of a clock edge, from 1.
using Time = std::uint64_t;

/// The numbers that the parts have in the agenda. At one edge a part comes before those with higher numbers: the pixels
/// before their decoder, which can take a word where they take a command; graphics processors come in their order. The
/// order of the others does not matter.
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

/// Who comes after `number` of so many that take turns.
constexpr std::size_t next_in_turn(std::size_t number, std::size_t count) {
  return number + 1 == count ? 0 : number + 1;
}

/// Some of the numbers below a count.
class Numbers {
 public:
  explicit Numbers(std::size_t count) : words_((count + 63) / 64) {}

  [[nodiscard]] bool empty() const {
    return std::ranges::all_of(words_, [](std::uint64_t word) { return word == 0; });
  }
  void add(std::size_t number) { words_[number / 64] |= bit(number); }
  void remove(std::size_t number) { words_[number / 64] &= ~bit(number); }

  /// The least, if there is any, which is no longer there then.
  std::optional<std::size_t> take() {
    for (std::size_t i = 0; i < words_.size(); ++i) {
      const std::uint64_t word = words_[i];
      if (word == 0) continue;
      words_[i] = word & (word - 1);
      return i * 64 + static_cast<std::size_t>(std::countr_zero(word));
    }
    return std::nullopt;
  }

  /// Calls `ask` with each, once around from `first` on, as long as it returns true. Only the one that is asked may
  /// change meanwhile.
  template <class Ask>
  void each_from(std::size_t first, const Ask& ask) const {
    if (words_.empty()) return;
    const std::uint64_t before_first = bit(first) - 1;
    if (!each_in(first / 64, ~before_first, ask)) return;
    for (std::size_t i = 1; i < words_.size(); ++i)
      if (!each_in((first / 64 + i) % words_.size(), ~std::uint64_t{0}, ask)) return;
    each_in(first / 64, before_first, ask);
  }

 private:
  static constexpr std::uint64_t bit(std::size_t number) { return std::uint64_t{1} << number % 64; }

  template <class Ask>
  bool each_in(std::size_t word, std::uint64_t mask, const Ask& ask) const {
    for (std::uint64_t left = words_[word] & mask; left != 0; left &= left - 1)
      if (!ask(word * 64 + static_cast<std::size_t>(std::countr_zero(left)))) return false;
    return true;
  }

  std::vector<std::uint64_t> words_;
};

/// When which part acts next. A part sleeps while nothing but another part can let it go on. Most parts act again at
/// the next edge: those of this edge and of the next are sets of bits, the others a heap.
class Agenda {
 public:
  explicit Agenda(std::size_t parts) : due_(parts, never), here_(parts), next_(parts) {}

  /// Whatever stood there for the part is forgotten. `when` is this edge or a later one.
  void put(std::size_t part, Time when) {
    due_[part] = when;
    if (when == now_) {
      here_.add(part);
    } else if (when == now_ + 1) {
      next_.add(part);
    } else {
      later_.emplace(when, part);
    }
  }

  /// Has a sleeping part look again.
  void wake(std::size_t part, Time when) {
    if (due_[part] == never) put(part, when);
  }

  /// The part that acts next, and when.
  std::pair<Time, std::size_t> next() {
    for (;;) {
      const std::optional<std::size_t> part = here_.take();
      if (!part) {
        go_on();
      } else if (due_[*part] == now_) {
        due_[*part] = never;
        return {now_, *part};
      }
    }
  }

 private:
  static constexpr Time never = ~Time{0};

  /// To the next edge at which a part acts.
  void go_on() {
    now_ = next_.empty() ? later_.top().first : now_ + 1;
    std::swap(here_, next_);
    for (; !later_.empty() && later_.top().first == now_; later_.pop()) here_.add(later_.top().second);
  }

  using Entry = std::pair<Time, std::size_t>;
  Time now_ = 0;
  std::vector<Time> due_;  ///< of each part, or never
  Numbers here_;
  Numbers next_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> later_;
};

/// Between two parts: a word wakes its reader, a free place its writer.
template <class Word>
class Fifo {
 public:
  Fifo(std::size_t depth, std::size_t writer, std::size_t reader, Agenda& agenda)
      : depth_(depth), writer_(writer), reader_(reader), agenda_(&agenda) {}

  [[nodiscard]] bool has_word(Time now) const { return !words_.empty() && words_.front().second < now; }
  [[nodiscard]] bool has_room(Time now) const { return words_.size() + (read_ == now ? 1U : 0U) < depth_; }

  /// Without a word (without room) now, there is one at the next edge.
  [[nodiscard]] bool word_follows() const { return !words_.empty(); }
  [[nodiscard]] bool room_follows() const { return words_.size() < depth_; }

  [[nodiscard]] const Word& oldest() const { return words_.front().first; }

  /// From now on `number` is among those as long as there is a word.
  void show(Numbers& with_words, std::size_t number) {
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
  boost::circular_buffer<std::pair<Word, Time>> words_;  ///< with the edge at which each was written
  Time read_ = 0;                                        ///< edge of the last read
  Numbers* with_words_ = nullptr;
  std::size_t number_ = 0;
};

/// The clocks of a part, accounted for in order.
class PartClocks {
 public:
  void work(Time clocks) { add(SquareActivity::working, clocks); }

  /// Did that in all clocks before `now` that have not been accounted for.
  void wait(SquareActivity why, Time now) { add(why, now - next_); }

  /// The frame's clocks, `end` the last.
  [[nodiscard]] const SquareClocks& whole(Time end) {
    wait(SquareActivity::done, end + 1);
    return clocks_;
  }

 private:
  void add(SquareActivity activity, Time clocks) {
    clocks_.add(activity, clocks);
    next_ += clocks;
  }

  SquareClocks clocks_;
  Time next_ = 1;
};

}  // namespace csgsim::pixel_square
