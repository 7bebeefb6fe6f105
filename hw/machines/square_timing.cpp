#include <algorithm>
#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "hw/machines/clocks.h"
#include "hw/machines/runs_on.h"
#include "hw/machines/timing.h"

namespace csgsim::machines {

namespace {

/// Number of a clock edge, from 1.
using Time = std::uint64_t;

/// Every part acts at edges, on what the edges before have left: the order of the parts at one edge does not matter.
template <class Word>
class Fifo {
 public:
  explicit Fifo(std::size_t depth) : depth_(depth) {}

  [[nodiscard]] bool has_word(Time now) const { return !words_.empty() && words_.front().second < now; }
  [[nodiscard]] bool has_room(Time now) const { return words_.size() + (read_ == now ? 1U : 0U) < depth_; }

  /// Without a word (without room) now, there is one at the next edge.
  [[nodiscard]] bool word_follows() const { return !words_.empty(); }
  [[nodiscard]] bool room_follows() const { return words_.size() < depth_; }

  void write(Time now, Word word) { words_.emplace_back(word, now); }
  Word read(Time now) {
    const Word word = words_.front().first;
    words_.pop_front();
    read_ = now;
    return word;
  }

 private:
  std::size_t depth_;
  std::deque<std::pair<Word, Time>> words_;  ///< with the edge at which each was written
  Time read_ = 0;                            ///< edge of the last read
};

/// The clocks of a part, accounted for in order.
class Part {
 public:
  void work(Time clocks) { add(SquareActivity::working, clocks); }

  /// Did that in all clocks before `now` that have not been accounted for.
  void wait(SquareActivity why, Time now) { add(why, now - next_); }

  /// The frame's clocks, `end` the last.
  [[nodiscard]] const SquareClocks& whole(SquareActivity rest, Time end) {
    wait(rest, end + 1);
    return clocks_;
  }

 private:
  void add(SquareActivity activity, Time clocks) {
    clocks_[static_cast<std::size_t>(activity)] += clocks;
    next_ += clocks;
  }

  SquareClocks clocks_{};
  Time next_ = 1;
};

/// When which part acts next. A part sleeps while nothing but another part can let it go on.
class Agenda {
 public:
  explicit Agenda(std::size_t parts) : awake_(parts) {}

  void put(std::size_t part, Time when) {
    awake_[part] = true;
    entries_.emplace(when, part);
  }

  /// Has a sleeping part look again.
  void wake(std::size_t part, Time when) {
    if (!awake_[part]) put(part, when);
  }

  std::pair<Time, std::size_t> next() {
    const Entry entry = entries_.top();
    entries_.pop();
    awake_[entry.second] = false;
    return entry;
  }

 private:
  using Entry = std::pair<Time, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> entries_;
  std::vector<bool> awake_;
};

/// What the divider sends to a renderer: an instruction's clocks; 0 is the end of the square.
struct InstructionWord {
  std::uint64_t clocks = 0;
  std::uint64_t colour_words = 0;  ///< with the end: that the square moves out in
};

struct ColourWord {
  bool last = false;
};

struct ClearWord {};

struct RendererState {
  explicit RendererState(std::size_t depth) : instructions(depth), colours(depth) {}

  /// The pixels have no square that waits to leave them.
  [[nodiscard]] bool takes_words() const { return !drawn && !moving; }

  Fifo<InstructionWord> instructions;
  Fifo<ColourWord> colours;
  Part part;

  std::optional<std::uint64_t> drawn;  ///< words of a square that is drawn and has not moved
  bool moving = false;                 ///< a square that leaves from the pixels' memory
  std::uint64_t words_left = 0;        ///< of the square that moves out
  Time moved_out = 0;                  ///< edge of its last word
  std::uint64_t handed = 0;
  std::uint64_t finished = 0;
  Time finished_at = 0;
};

/// A frame, from edge to edge at which something happens.
class Frame {
 public:
  Frame(const isa::Program& program, const Machine& machine)
      : program_(program),
        machine_(machine),
        figures_(machine.pixel_square),
        colour_bits_(isa::field_of(program, isa::FieldRole::colour).width),
        latency_(evaluator_latency(machine.array)),
        clears_(figures_.fifo_depth),
        renderers_(figures_.renderers, RendererState(figures_.fifo_depth)),
        agenda_(2 * std::size_t{figures_.renderers} + 2) {}

  FrameTiming run() {
    if (!program_.segments.empty()) {
      take_model();
      while (end_ == 0) step();
    }
    return {end_, account()};
  }

 private:
  [[nodiscard]] std::size_t renderer_part(std::size_t renderer) const { return renderer; }
  [[nodiscard]] std::size_t output_part(std::size_t renderer) const { return renderers_.size() + renderer; }
  [[nodiscard]] std::size_t divider_part() const { return 2 * renderers_.size(); }
  [[nodiscard]] std::size_t frame_buffer_part() const { return divider_part() + 1; }

  void step() {
    const auto [now, part] = agenda_.next();
    if (part == divider_part()) return divide(now);
    if (part == frame_buffer_part()) return store(now);
    if (part < renderers_.size()) return draw(part, now);
    move(part - renderers_.size(), now);
  }

  /// The words of the model follow each other as fast as the host can send and the FIFO take them.
  void take_model() {
    const std::uint64_t words = program_.model.primitives + program_.model.halfspaces;
    const Time spacing = std::max<Time>(figures_.host_word_clocks, figures_.fifo_depth == 1 ? 2 : 1);
    Time start = 1;
    if (words > 0) {
      const Time sent = figures_.host_word_clocks + (words - 1) * spacing;
      start = sent + 2;
      host_.work(words * figures_.host_word_clocks);
      host_.wait(SquareActivity::waiting_for_divider, sent + 1);
      divider_.work(words);
      divider_.wait(SquareActivity::waiting_for_host, start);
    }
    begin_square(0, start);
  }

  void begin_square(std::size_t square, Time now) {
    square_ = square;
    index_ = 0;
    target_.reset();
    if (square_ == program_.segments.size()) return;
    const Time tests = program_.model.primitives * figures_.primitive_clocks +
                       std::uint64_t{program_.segments[square_].halfspaces} * figures_.halfspace_clocks;
    divider_.work(tests);
    agenda_.put(divider_part(), now + tests);
  }

  void divide(Time now) {
    if (square_ == program_.segments.size()) return;
    program_.segments[square_].instructions.empty() ? clear(now) : send(now);
  }

  void clear(Time now) {
    if (!clears_.has_room(now)) {
      if (clears_.room_follows()) agenda_.put(divider_part(), now + 1);
      return;
    }
    clears_.write(now, {});
    agenda_.wake(frame_buffer_part(), now + 1);
    divider_.wait(SquareActivity::waiting_for_frame_buffer, now);
    divider_.work(1);
    ++skipped_;
    begin_square(square_ + 1, now + 1);
  }

  void send(Time now) {
    if (!target_) {
      target_ = least_busy(now);
      ++renderers_[*target_].handed;
    }
    Fifo<InstructionWord>& link = renderers_[*target_].instructions;
    if (!link.has_room(now)) {
      if (link.room_follows()) agenda_.put(divider_part(), now + 1);
      return;
    }
    const isa::Segment& segment = program_.segments[square_];
    const bool end = index_ == segment.instructions.size();
    link.write(now, end ? InstructionWord{0, colour_words(segment.region)}
                        : InstructionWord{clocks(segment.instructions[index_], machine_), 0});
    if (renderers_[*target_].takes_words()) agenda_.wake(renderer_part(*target_), now + 1);
    divider_.wait(SquareActivity::waiting_for_renderer, now);
    divider_.work(1);
    ++index_;
    if (end) return begin_square(square_ + 1, now + 1);
    agenda_.put(divider_part(), now + 1);
  }

  [[nodiscard]] std::uint64_t colour_words(const isa::Region& region) const {
    const std::uint64_t bits = std::uint64_t{region.width} * region.height * colour_bits_;
    return std::max<std::uint64_t>(1, (bits + figures_.port_bits - 1) / figures_.port_bits);
  }

  [[nodiscard]] std::size_t least_busy(Time now) const {
    const auto unfinished = [now](const RendererState& one) {
      return one.handed - one.finished + (one.finished_at == now ? 1 : 0);
    };
    const auto best =
        std::min_element(renderers_.begin(), renderers_.end(),
                         [&](const RendererState& a, const RendererState& b) { return unfinished(a) < unfinished(b); });
    return static_cast<std::size_t>(best - renderers_.begin());
  }

  void draw(std::size_t renderer, Time now) {
    RendererState& one = renderers_[renderer];
    if (one.drawn) return move_out(renderer, now);
    if (!one.instructions.has_word(now)) {
      if (one.instructions.word_follows()) agenda_.put(renderer_part(renderer), now + 1);
      return;
    }
    one.part.wait(SquareActivity::waiting_for_divider, now);
    const InstructionWord word = one.instructions.read(now);
    agenda_.wake(divider_part(), now + 1);
    if (word.clocks > 0) {
      one.part.work(word.clocks);
      return agenda_.put(renderer_part(renderer), now + word.clocks);
    }
    one.drawn = word.colour_words;
    one.part.work(1 + latency_);
    agenda_.put(renderer_part(renderer), now + latency_);
  }

  /// A drawn square leaves the pixels when the one before it has moved out at an earlier edge.
  void move_out(std::size_t renderer, Time now) {
    RendererState& one = renderers_[renderer];
    if (one.words_left > 0) return;
    if (one.moved_out == now) return agenda_.put(renderer_part(renderer), now + 1);
    one.words_left = *std::exchange(one.drawn, std::nullopt);
    agenda_.put(output_part(renderer), now + 1);
    one.moving = figures_.buffers == 1;
    if (!one.moving) finish(renderer, now);
  }

  /// The pixels are free from the next edge on.
  void finish(std::size_t renderer, Time now) {
    RendererState& one = renderers_[renderer];
    one.moving = false;
    ++one.finished;
    one.finished_at = now;
    one.part.wait(SquareActivity::waiting_for_frame_buffer, now + 1);
    agenda_.put(renderer_part(renderer), now + 1);
  }

  void move(std::size_t renderer, Time now) {
    RendererState& one = renderers_[renderer];
    if (!one.colours.has_room(now)) {
      if (one.colours.room_follows()) agenda_.put(output_part(renderer), now + 1);
      return;
    }
    one.colours.write(now, {.last = one.words_left == 1});
    agenda_.wake(frame_buffer_part(), now + 1);
    if (--one.words_left > 0) return agenda_.put(output_part(renderer), now + 1);
    one.moved_out = now;
    if (one.moving) return finish(renderer, now);
    if (one.drawn) agenda_.wake(renderer_part(renderer), now + 1);
  }

  /// Renderers and, as the last, the divider take turns.
  void store(Time now) {
    const std::size_t ports = renderers_.size() + 1;
    bool word_follows = false;
    for (std::size_t i = 0; i < ports; ++i) {
      const std::size_t port = (turn_ + i) % ports;
      const bool from_divider = port == renderers_.size();
      if (from_divider ? clears_.has_word(now) : renderers_[port].colours.has_word(now)) return take(port, now);
      word_follows = word_follows || (from_divider ? clears_.word_follows() : renderers_[port].colours.word_follows());
    }
    if (word_follows) agenda_.put(frame_buffer_part(), now + 1);
  }

  void take(std::size_t port, Time now) {
    bool square_ends = true;
    if (port == renderers_.size()) {
      clears_.read(now);
      agenda_.wake(divider_part(), now + 1);
    } else {
      square_ends = renderers_[port].colours.read(now).last;
      if (renderers_[port].words_left > 0) agenda_.wake(output_part(port), now + 1);
    }
    turn_ = (port + 1) % (renderers_.size() + 1);
    frame_buffer_.wait(SquareActivity::waiting_for_renderer, now);
    frame_buffer_.work(1);
    if (square_ends && ++stored_ == program_.segments.size()) end_ = now;
    agenda_.put(frame_buffer_part(), now + 1);
  }

  SquareAccount account() {
    SquareAccount account;
    account.squares_skipped = skipped_;
    account.host = host_.whole(SquareActivity::done, end_);
    account.divider = divider_.whole(SquareActivity::done, end_);
    for (RendererState& one : renderers_) {
      account.squares_drawn += one.finished;
      account.renderers.push_back(one.part.whole(SquareActivity::done, end_));
      account.renderer_squares.push_back(one.finished);
    }
    account.frame_buffer = frame_buffer_.whole(SquareActivity::done, end_);
    return account;
  }

  const isa::Program& program_;
  const Machine& machine_;
  const PixelSquare& figures_;
  std::uint32_t colour_bits_;
  Time latency_;
  Fifo<ClearWord> clears_;
  std::vector<RendererState> renderers_;
  Agenda agenda_;
  Part host_;
  Part divider_;
  Part frame_buffer_;

  std::size_t square_ = 0;  ///< that the divider is at
  std::size_t index_ = 0;   ///< of the instruction it sends next
  std::optional<std::size_t> target_;
  std::uint64_t skipped_ = 0;
  std::size_t turn_ = 0;  ///< port that the frame buffer asks first
  std::uint64_t stored_ = 0;
  Time end_ = 0;
};

}  // namespace

FrameTiming time_squares(const isa::Program& program, const Machine& machine) {
  check_countable(program, machine);
  return Frame(program, machine).run();
}

}  // namespace csgsim::machines
