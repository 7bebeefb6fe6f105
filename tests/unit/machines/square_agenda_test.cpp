#include <rapidcheck.h>

#include "hw/pixel_square/timing_agenda.h"
#include "hw/pixel_square/timing_leaving.h"
#include "hw/pixel_square/timing_renderer.h"
#include "hw/pixel_square/timing_store.h"
#include "tests/support/test.h"

// Tests of the event agenda, FIFOs and stores that the pixel-square timing is computed with.

using namespace csgsim;
using pixel_square::Agenda;
using pixel_square::Fifo;
using pixel_square::IndexSet;
using pixel_square::LeavingSquare;
using pixel_square::PartNumbers;
using pixel_square::RowLatch;
using pixel_square::SquareActivity;
using pixel_square::StoreTiming;
using pixel_square::Time;
using pixel_square::TimedStored;

namespace {

constexpr std::size_t many = 200;  // more than three words of 64

using Visited = std::vector<std::size_t>;

/// Returns the numbers visited from `first` on, at most `most`.
Visited visited(const IndexSet& numbers, std::size_t first, std::size_t most = many) {
  Visited all;
  numbers.for_each_from(first, [&](std::size_t number) {
    all.push_back(number);
    return all.size() < most;
  });
  return all;
}

Visited expected_round(const std::set<std::size_t>& numbers, std::size_t first, std::size_t most = many) {
  Visited all(numbers.lower_bound(first), numbers.end());
  all.insert(all.end(), numbers.begin(), numbers.lower_bound(first));
  all.resize(std::min(all.size(), most));
  return all;
}

std::size_t any_number() { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::size_t>(0, many)); }

}  // namespace

TEST_CASE("IndexSet visits its numbers once in cyclic order until the visitor stops") {
  CHECK(rc::check([] {
    IndexSet numbers(many);
    std::set<std::size_t> expected;
    RC_ASSERT(numbers.empty());
    for (int i = *rc::gen::inRange(0, 60); i > 0; --i) {
      const std::size_t number = any_number();
      if (*rc::gen::inRange(0, 4) == 0) {
        numbers.remove(number);
        expected.erase(number);
      } else {
        numbers.add(number);
        expected.insert(number);
      }
    }
    RC_ASSERT(numbers.empty() == expected.empty());
    for (int i = 0; i < 5; ++i) {
      const std::size_t first = any_number();
      RC_ASSERT(visited(numbers, first) == expected_round(expected, first));
      const auto most = *rc::gen::inRange<std::size_t>(1, 9);
      RC_ASSERT(visited(numbers, first, most) == expected_round(expected, first, most));
    }
    for (const std::size_t number : expected) RC_ASSERT(numbers.take() == std::optional(number));
    RC_ASSERT(numbers.take() == std::nullopt);
    RC_ASSERT(numbers.empty());
  }));
}

TEST_CASE("IndexSet visits numbers at the ends of 64-bit words in order") {
  const std::set<std::size_t> edges{0, 1, 62, 63, 64, 65, 127, 128, 191, 192};
  IndexSet numbers(193);
  for (const std::size_t number : edges) numbers.add(number);
  for (const std::size_t first : edges) CHECK(visited(numbers, first) == expected_round(edges, first));
  CHECK(visited(numbers, 2, 3) == Visited{62, 63, 64});
  CHECK(visited(numbers, 128, 3) == Visited{128, 191, 192});
  CHECK(visited(numbers, 192, 3) == Visited{192, 0, 1});
  CHECK(visited(IndexSet(0), 0).empty());
  CHECK(IndexSet(0).empty());
  CHECK(visited(IndexSet(64), 5).empty());
}

TEST_CASE("next_in_turn() returns the following number and 0 after the last") {
  CHECK(pixel_square::next_in_turn(0, 1) == 0);
  CHECK(pixel_square::next_in_turn(0, 2) == 1);
  CHECK(pixel_square::next_in_turn(1, 2) == 0);
  CHECK(pixel_square::next_in_turn(5, 9) == 6);
}

TEST_CASE("the parts of a machine are numbered consecutively with pixels before decoders") {
  const PartNumbers parts{.renderers = 3, .dividers = 2, .processors = 4};
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < 3; ++i) all.push_back(parts.pixels(i));
  for (std::size_t i = 0; i < 3; ++i) all.push_back(parts.decoder(i));
  for (std::size_t i = 0; i < 3; ++i) all.push_back(parts.output(i));
  all.insert(all.end(), {parts.sender(), parts.frame_buffer(), parts.ring(), parts.divider(0), parts.divider(1)});
  for (std::size_t i = 0; i < 4; ++i) all.push_back(parts.processor(i));
  for (std::size_t i = 0; i < all.size(); ++i) CHECK(all[i] == i);
  CHECK(parts.count() == all.size());
  CHECK(PartNumbers{}.count() == 6);  // one renderer of three parts, the sender, the frame buffer, the ring
}

TEST_CASE("parts act at their latest scheduled clock edge in order of their numbers") {
  CHECK(rc::check([] {
    Agenda agenda(many);
    std::map<std::size_t, Time> due;
    Time now = 0;
    const auto any_time = [&] {
      return now + *rc::gen::resize(rc::kNominalSize,
                                    rc::gen::weightedElement<Time>({{3, 0}, {6, 1}, {2, 2}, {1, 3}, {1, 70}}));
    };
    const auto put = [&](std::size_t part, Time when) {
      agenda.schedule(part, when);
      due[part] = when;
    };
    put(any_number(), any_time());
    for (int step = 0; step < 100 && !due.empty(); ++step) {
      for (int i = *rc::gen::inRange(0, 3); i > 0; --i) put(any_number(), any_time());
      const std::size_t sleeper = any_number();
      const Time when = any_time();
      agenda.wake(sleeper, when);
      due.emplace(sleeper, when);  // a part that is already scheduled stays
      std::pair<Time, std::size_t> expected{~Time{0}, 0};
      for (const auto& [part, time] : due) expected = std::min(expected, {time, part});
      RC_ASSERT(agenda.next() == expected);
      now = expected.first;
      due.erase(expected.second);
    }
  }));
}

TEST_CASE("a word written to a FIFO and a place freed in it take effect one edge later") {
  Agenda agenda(2);
  Fifo<int> fifo(2, 0, 1, agenda);
  CHECK_FALSE(fifo.has_word(0));
  CHECK_FALSE(fifo.has_word_next());
  CHECK(fifo.has_room(1));
  fifo.write(1, 7);
  CHECK(agenda.next() == std::pair<Time, std::size_t>{2, 1});  // wakes the reader
  CHECK_FALSE(fifo.has_word(1));
  CHECK(fifo.has_word_next());
  CHECK(fifo.has_word(2));
  CHECK(fifo.oldest() == 7);
  CHECK(fifo.has_room(2));
  fifo.write(2, 8);
  CHECK_FALSE(fifo.has_room(3));
  CHECK_FALSE(fifo.has_room_next());
  CHECK(agenda.next() == std::pair<Time, std::size_t>{3, 1});
  CHECK(fifo.read(3) == 7);
  CHECK_FALSE(fifo.has_room(3));
  CHECK(fifo.has_room_next());
  CHECK(fifo.has_room(4));
  CHECK(agenda.next() == std::pair<Time, std::size_t>{4, 0});  // wakes the writer
  CHECK(fifo.has_word(3));
  CHECK(fifo.read(4) == 8);
  CHECK_FALSE(fifo.has_word_next());
}

TEST_CASE("a FIFO returns any number of words in order") {
  Agenda agenda(2);
  Fifo<int> fifo(100, 0, 1, agenda);
  IndexSet with_words(70);
  fifo.track_in(with_words, 65);
  int read = 0;
  int written = 0;
  for (const int more : {5, 30, 8, 60, 1}) {
    for (int i = 0; i < more; ++i) fifo.write(1, written++);
    CHECK(visited(with_words, 0) == Visited{65});
    for (int i = 0; i < more - 1; ++i) CHECK(fifo.read(2) == read++);
  }
  while (read < written) {
    CHECK(visited(with_words, 0) == Visited{65});
    CHECK(fifo.read(2) == read++);
  }
  CHECK(with_words.empty());
}

TEST_CASE("a square can start when its last word is stored or when the store is full") {
  Agenda agenda(2);
  const TimedStored part;
  const TimedStored last{.whole = std::nullopt, .is_last = true};
  StoreTiming store(3, 0, 1, agenda);
  store.write(1, part);
  CHECK_FALSE(store.may_begin(5));
  store.write(2, last);
  CHECK_FALSE(store.may_begin(2));
  CHECK(store.may_begin(3));
  CHECK_FALSE(store.read(3).is_last);
  CHECK(store.may_begin(4));
  CHECK(store.read(4).is_last);
  CHECK_FALSE(store.may_begin(9));
  for (const Time now : {5U, 6U}) store.write(now, part);
  CHECK_FALSE(store.may_begin(9));
  store.write(7, part);
  CHECK_FALSE(store.may_begin(7));
  CHECK(store.may_begin(8));
  store.read(8);
  CHECK_FALSE(store.may_begin(9));
  // Two end marks: the first is stored before the second.
  StoreTiming both(9, 0, 1, agenda);
  both.write(1, last);
  both.write(4, last);
  CHECK(both.may_begin(2));
  both.read(2);
  CHECK_FALSE(both.may_begin(4));
  CHECK(both.may_begin(5));
}

TEST_CASE("a departing word reports its rows in the square and in the picture") {
  CHECK(rc::check([] {
    const isa::Region region{3, *rc::gen::inRange<std::uint32_t>(0, 50), *rc::gen::inRange<std::uint32_t>(1, 9),
                             *rc::gen::inRange<std::uint32_t>(1, 9)};
    const auto colour_bits = *rc::gen::inRange<std::uint32_t>(1, 25);
    const auto port_bits = *rc::gen::inRange<std::uint64_t>(1, 300);
    const std::uint64_t row_bits = std::uint64_t{region.width} * colour_bits;
    const std::uint64_t all_bits = row_bits * region.height;
    LeavingSquare square(region, colour_bits, port_bits);
    LeavingSquare background = square;
    const auto words_of = [&](std::uint64_t bits) {
      std::uint64_t words = 0;
      for (std::uint64_t gone = 0; gone < bits; gone += port_bits) ++words;
      return words;
    };
    for (std::uint64_t i = 0; i < words_of(64); ++i) {
      RC_ASSERT(square.words_left() == words_of(64) - i + words_of(all_bits));
      RC_ASSERT(!square.rows());
      RC_ASSERT(!square.picture_row());
      square.advance();
    }
    background.skip_header();
    for (std::uint64_t bit = 0; bit < all_bits; bit += port_bits) {
      for (LeavingSquare* const one : {&square, &background}) {
        RC_ASSERT(one->words_left() == words_of(all_bits) - bit / port_bits);
        RC_ASSERT(one->rows().value().first == bit / row_bits);
        RC_ASSERT(one->rows().value().last == (std::min(bit + port_bits, all_bits) - 1) / row_bits);
        RC_ASSERT(one->picture_row() == region.y + bit / row_bits);
        one->advance();
      }
    }
    RC_ASSERT(square.words_left() == 0U);
    RC_ASSERT(background.words_left() == 0U);
  }));
}

TEST_CASE("a square's header takes 64 bits in whole port words") {
  for (const auto& [port_bits, words] :
       std::vector<std::pair<std::uint64_t, std::uint64_t>>{{1, 64}, {8, 8}, {63, 2}, {64, 1}, {65, 1}, {1000, 1}})
    CHECK(pixel_square::header_words(port_bits) == words);
}

TEST_CASE("a latched row transfers when a word needs it and the next row is latched") {
  // The square starts to leave at 10: the first row is latched at 11 to 14 and transfers at 15; the second is latched
  // at 15 to 18.
  RowLatch latch(4, 10);
  CHECK(latch.transfer_edge(0) == 15);
  CHECK(latch.transfer_edge(0) == 15);
  CHECK(latch.transfer_edge(1) == 19);
  // The third row, not needed before 41, is latched at 19 to 22 and transfers at 41; the fourth at 45.
  latch.record_word(40);
  CHECK(latch.transfer_edge(2) == 41);
  CHECK(latch.transfer_edge(3) == 45);
  // A word that needs two rows waits for both.
  RowLatch quick(1, 0);
  CHECK(quick.transfer_edge(1) == 3);
}

TEST_CASE("the clocks of a part cover the frame from its first clock to its last") {
  pixel_square::PartClocks clocks;
  clocks.count_waiting(SquareActivity::waiting_for_host, 4);  // clocks 1 to 3
  clocks.count_working(2);                                    // 4 and 5
  clocks.count_waiting(SquareActivity::waiting_for_renderer, 6);
  clocks.count_waiting(SquareActivity::waiting_for_renderer, 7);  // 6
  const pixel_square::SquareClocks& whole = clocks.complete(10);
  CHECK(whole == pixel_square::SquareClocks{2, 3, 0, 1, 0, 4});
}