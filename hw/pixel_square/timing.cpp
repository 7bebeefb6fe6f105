#include "hw/pixel_square/timing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "hw/base/error.h"
#include "hw/isa/wire.h"
#include "hw/machines/clocks.h"
#include "hw/pixel_square/account.h"
#include "hw/pixel_square/figures.h"

namespace csgsim::pixel_square {

namespace {

using machines::FrameTiming;
using machines::Machine;

constexpr std::uint64_t header_bits = 64;  ///< of a square on its way to the frame buffer

std::uint64_t words_of(std::uint64_t bits, std::uint64_t word_bits) { return (bits + word_bits - 1) / word_bits; }

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
  explicit Agenda(std::size_t parts) : due_(parts, never) {}

  /// Whatever stood there for the part is forgotten.
  void put(std::size_t part, Time when) {
    due_[part] = when;
    entries_.emplace(when, part);
  }

  /// Has a sleeping part look again.
  void wake(std::size_t part, Time when) {
    if (due_[part] == never) put(part, when);
  }

  std::pair<Time, std::size_t> next() {
    Entry entry = pop();
    while (due_[entry.second] != entry.first) entry = pop();
    due_[entry.second] = never;
    return entry;
  }

 private:
  using Entry = std::pair<Time, std::size_t>;
  static constexpr Time never = ~Time{0};

  Entry pop() {
    const Entry entry = entries_.top();
    entries_.pop();
    return entry;
  }

  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> entries_;
  std::vector<Time> due_;  ///< of each part, or never
};

enum class CommandKind : std::uint8_t { start, instruction, end };

/// What a renderer is told.
struct Command {
  CommandKind kind = CommandKind::start;
  std::uint64_t words = 0;         ///< on the link
  std::uint64_t clocks = 0;        ///< of the pixels' controller
  std::uint64_t colour_words = 0;  ///< with the end: that the square leaves in
};

/// Some bits of a command; the last bring the whole of it.
struct LinkWord {
  std::optional<Command> whole;
};

struct PortWord {
  bool last = false;               ///< of the square, or of the header of one to clear
  std::uint64_t clear_clocks = 0;  ///< with such a header
};

struct RendererState {
  RendererState(std::size_t link_depth, std::size_t port_depth) : link(link_depth), colours(port_depth) {}

  Fifo<LinkWord> link;
  Fifo<PortWord> colours;
  Part part;

  std::optional<Command> command;      ///< that the decoder holds
  std::optional<std::uint64_t> drawn;  ///< words of a square that is drawn and has not moved
  bool moving = false;                 ///< a square, to the second buffer
  bool leaving = false;                ///< a square, from the pixels' memory
  std::uint64_t words_left = 0;        ///< of the square that leaves
  Time left = 0;                       ///< edge of its last word
  std::uint64_t handed = 0;
  std::uint64_t finished = 0;
  Time finished_at = 0;
};

/// A frame, from edge to edge at which something happens.
class FrameModel {
 public:
  FrameModel(const isa::Program& program, const Machine& machine)
      : program_(program),
        machine_(machine),
        figures_(machines::own<Figures>(machine)),
        colour_bits_(isa::frame_header(program).colour.width),
        latency_(machines::evaluator_latency(machine.array)),
        move_clocks_(figures_.move_bits == all_planes ? 0 : words_of(colour_bits_, figures_.move_bits)),
        clears_(figures_.port_fifo_depth),
        renderers_(figures_.renderers, RendererState(machine.link.fifo_depth, figures_.port_fifo_depth)),
        agenda_(3 * std::size_t{figures_.renderers} + 2) {}

  SquareTiming run() {
    if (!program_.segments.empty()) {
      figures_.divider == DividerKind::host ? begin_square(0, wait_for_host()) : begin_square(0, take_model());
      while (end_ == 0) step();
    }
    return {end_, counted()};
  }

 private:
  // At one edge the pixels come before their decoder, which can take a word where they take a command. The order of
  // the others does not matter.
  [[nodiscard]] static std::size_t pixels_part(std::size_t renderer) { return renderer; }
  [[nodiscard]] std::size_t decoder_part(std::size_t renderer) const { return renderers_.size() + renderer; }
  [[nodiscard]] std::size_t output_part(std::size_t renderer) const { return 2 * renderers_.size() + renderer; }
  [[nodiscard]] std::size_t sender_part() const { return 3 * renderers_.size(); }
  [[nodiscard]] std::size_t frame_buffer_part() const { return sender_part() + 1; }

  void step() {
    const auto [now, part] = agenda_.next();
    if (part == sender_part()) return send(now);
    if (part == frame_buffer_part()) return store(now);
    const std::size_t renderer = part % renderers_.size();
    if (part == pixels_part(renderer)) return draw(renderer, now);
    if (part == decoder_part(renderer)) return decode(renderer, now);
    leave(renderer, now);
  }

  Time wait_for_host() {
    const Time first = 1 + machine_.link.latency;
    sender_.wait(SquareActivity::waiting_for_host, first);
    return first;
  }

  /// The words of the model follow each other as fast as the host can send and the FIFO take them. Returns the edge
  /// after that at which the divider takes the last.
  Time take_model() {
    const std::uint64_t words = words_of(8 * std::uint64_t{program_.display_model.size()}, machine_.link.width);
    if (words == 0) return 1;
    const Time spacing = std::max<Time>(machine_.link.word_clocks, machine_.link.fifo_depth == 1 ? 2 : 1);
    const Time sent = machine_.link.latency + machine_.link.word_clocks + (words - 1) * spacing;
    host_.wait(SquareActivity::waiting_for_host, 1 + machine_.link.latency);
    host_.work(words * machine_.link.word_clocks);
    host_.wait(SquareActivity::waiting_for_divider, sent + 1);
    sender_.work(words);
    sender_.wait(SquareActivity::waiting_for_host, sent + 2);
    return sent + 2;
  }

  /// Of the divider, before the square's commands can leave.
  [[nodiscard]] Time test_clocks(const isa::DivisionFacts& tests) const {
    if (figures_.divider == DividerKind::host) return 0;
    return (tests.boxes + tests.group_boxes) * figures_.box_clocks +
           (tests.halfspaces + tests.group_halfspaces) * figures_.halfspace_clocks +
           (tests.cells + tests.group_cells) * figures_.cell_clocks + tests.nodes * figures_.node_clocks;
  }

  /// Clocks from a word of a square to the next.
  [[nodiscard]] Time word_clocks() const {
    return figures_.divider == DividerKind::host ? machine_.link.word_clocks : 1;
  }

  void begin_square(std::size_t square, Time now) {
    square_ = square;
    sent_ = 0;
    target_.reset();
    commands_.clear();
    if (square_ == program_.segments.size()) return;
    const isa::Segment& segment = program_.segments[square_];
    if (segment.instructions.empty()) {
      words_ = header_words();
    } else {
      list_commands(segment);
    }
    const Time tests = test_clocks(segment.facts.division);
    sender_.work(tests);
    ready(now + tests);
  }

  void list_commands(const isa::Segment& segment) {
    const std::uint32_t width = machine_.link.width;
    commands_.reserve(segment.instructions.size() + 2);
    commands_.push_back({.kind = CommandKind::start,
                         .words = isa::wire_words(isa::SegmentStart{segment.region}, width),
                         .clocks = std::max<std::uint64_t>(1, machine_.clear_clocks)});
    for (const isa::Instruction& instruction : segment.instructions) {
      commands_.push_back({.kind = CommandKind::instruction,
                           .words = isa::wire_words(instruction, width),
                           .clocks = machines::bit_serial_clocks(instruction, machine_)});
    }
    commands_.push_back({.kind = CommandKind::end,
                         .words = isa::wire_words(isa::SegmentEnd{}, width),
                         .clocks = 1 + latency_,
                         .colour_words = header_words() + colour_words(segment.region)});
    command_ = 0;
    words_ = commands_.front().words;
  }

  [[nodiscard]] std::uint64_t header_words() const { return words_of(header_bits, figures_.port_bits); }

  [[nodiscard]] std::uint64_t colour_words(const isa::Region& region) const {
    return words_of(std::uint64_t{region.width} * region.height * colour_bits_, figures_.port_bits);
  }

  /// A word begins to leave.
  void ready(Time now) {
    sender_.work(word_clocks() - 1);
    agenda_.put(sender_part(), now + word_clocks() - 1);
  }

  void send(Time now) {
    if (square_ == program_.segments.size()) return;
    commands_.empty() ? send_header(now) : send_command(now);
  }

  void send_header(Time now) {
    if (!clears_.has_room(now)) {
      if (clears_.room_follows()) agenda_.put(sender_part(), now + 1);
      return;
    }
    const bool last = sent_ + 1 == words_;
    clears_.write(now, {last, last ? colour_words(program_.segments[square_].region) : 0});
    agenda_.wake(frame_buffer_part(), now + 1);
    sender_.wait(SquareActivity::waiting_for_frame_buffer, now);
    sender_.work(1);
    ++sent_;
    if (!last) return ready(now + 1);
    ++skipped_;
    begin_square(square_ + 1, now + 1);
  }

  void send_command(Time now) {
    if (!target_) {
      target_ = least_busy(now);
      ++renderers_[*target_].handed;
    }
    Fifo<LinkWord>& link = renderers_[*target_].link;
    if (!link.has_room(now)) {
      if (link.room_follows()) agenda_.put(sender_part(), now + 1);
      return;
    }
    const bool last = sent_ + 1 == words_;
    link.write(now, {last ? std::optional(commands_[command_]) : std::nullopt});
    agenda_.wake(decoder_part(*target_), now + 1);
    sender_.wait(SquareActivity::waiting_for_renderer, now);
    sender_.work(1);
    ++sent_;
    if (!last) return ready(now + 1);
    sent_ = 0;
    if (++command_ == commands_.size()) return begin_square(square_ + 1, now + 1);
    words_ = commands_[command_].words;
    ready(now + 1);
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

  void decode(std::size_t renderer, Time now) {
    RendererState& one = renderers_[renderer];
    if (one.command) return;
    if (!one.link.has_word(now)) {
      if (one.link.word_follows()) agenda_.put(decoder_part(renderer), now + 1);
      return;
    }
    one.command = one.link.read(now).whole;
    agenda_.wake(sender_part(), now + 1);
    one.command ? agenda_.wake(pixels_part(renderer), now + 1) : agenda_.put(decoder_part(renderer), now + 1);
  }

  void draw(std::size_t renderer, Time now) {
    RendererState& one = renderers_[renderer];
    if (one.moving) return finish(renderer, now);
    if (one.drawn) return move_out(renderer, now);
    if (one.leaving || !one.command) return;
    one.part.wait(SquareActivity::waiting_for_divider, now);
    const Command command = *std::exchange(one.command, std::nullopt);
    agenda_.wake(decoder_part(renderer), now);
    one.part.work(command.clocks);
    if (command.kind == CommandKind::end) {
      one.drawn = command.colour_words;
      return agenda_.put(pixels_part(renderer), now + latency_);
    }
    agenda_.put(pixels_part(renderer), now + command.clocks);
  }

  /// A drawn square leaves the pixels when the one before it has left at an earlier edge.
  void move_out(std::size_t renderer, Time now) {
    RendererState& one = renderers_[renderer];
    if (one.words_left > 0) return;
    if (one.left == now) return agenda_.put(pixels_part(renderer), now + 1);
    one.words_left = *std::exchange(one.drawn, std::nullopt);
    one.part.wait(SquareActivity::waiting_for_frame_buffer, now + 1);
    if (figures_.buffers == 1) {
      one.leaving = true;
      return agenda_.put(output_part(renderer), now + 1);
    }
    one.moving = true;
    if (move_clocks_ == 0) return finish(renderer, now);
    one.part.work(move_clocks_);
    agenda_.put(pixels_part(renderer), now + move_clocks_);
  }

  /// The pixels are free from the next edge on.
  void finish(std::size_t renderer, Time now) {
    RendererState& one = renderers_[renderer];
    if (one.leaving) {
      one.part.wait(SquareActivity::waiting_for_frame_buffer, now + 1);
    } else {
      agenda_.put(output_part(renderer), now + 1);
    }
    one.moving = false;
    one.leaving = false;
    ++one.finished;
    one.finished_at = now;
    agenda_.put(pixels_part(renderer), now + 1);
  }

  void leave(std::size_t renderer, Time now) {
    RendererState& one = renderers_[renderer];
    if (!one.colours.has_room(now)) {
      if (one.colours.room_follows()) agenda_.put(output_part(renderer), now + 1);
      return;
    }
    one.colours.write(now, {.last = one.words_left == 1});
    agenda_.wake(frame_buffer_part(), now + 1);
    if (--one.words_left > 0) return agenda_.put(output_part(renderer), now + 1);
    one.left = now;
    if (one.leaving) return finish(renderer, now);
    if (one.drawn) agenda_.wake(pixels_part(renderer), now + 1);
  }

  /// Renderers and, as the last, the sender take turns.
  void store(Time now) {
    const std::size_t ports = renderers_.size() + 1;
    bool word_follows = false;
    for (std::size_t i = 0; i < ports; ++i) {
      const std::size_t port = (turn_ + i) % ports;
      if (port == renderers_.size() && clear_left_ > 0) return clear(now);
      Fifo<PortWord>& fifo = port == renderers_.size() ? clears_ : renderers_[port].colours;
      if (fifo.has_word(now)) return take(port, now);
      word_follows = word_follows || fifo.word_follows();
    }
    if (word_follows) agenda_.put(frame_buffer_part(), now + 1);
  }

  void take(std::size_t port, Time now) {
    bool square_ends = false;
    if (port == renderers_.size()) {
      const PortWord word = clears_.read(now);
      clear_left_ = word.clear_clocks;
      square_ends = word.last && clear_left_ == 0;
      agenda_.wake(sender_part(), now + 1);
    } else {
      square_ends = renderers_[port].colours.read(now).last;
      if (renderers_[port].words_left > 0 && !renderers_[port].moving) agenda_.wake(output_part(port), now + 1);
    }
    served(port, square_ends, now);
  }

  void clear(Time now) { served(renderers_.size(), --clear_left_ == 0, now); }

  void served(std::size_t port, bool square_ends, Time now) {
    turn_ = (port + 1) % (renderers_.size() + 1);
    frame_buffer_.wait(SquareActivity::waiting_for_renderer, now);
    frame_buffer_.work(1);
    if (square_ends && ++stored_ == program_.segments.size()) end_ = now;
    agenda_.put(frame_buffer_part(), now + 1);
  }

  SquareAccount counted() {
    SquareAccount account;
    account.squares_skipped = skipped_;
    if (figures_.divider == DividerKind::host) {
      account.host = sender_.whole(SquareActivity::done, end_);
    } else {
      account.host = host_.whole(SquareActivity::done, end_);
      account.divider = sender_.whole(SquareActivity::done, end_);
    }
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
  const Figures& figures_;
  std::uint32_t colour_bits_;
  Time latency_;
  Time move_clocks_;
  Fifo<PortWord> clears_;
  std::vector<RendererState> renderers_;
  Agenda agenda_;
  Part host_;  ///< before a divider
  Part sender_;
  Part frame_buffer_;

  std::size_t square_ = 0;         ///< that the sender is at
  std::vector<Command> commands_;  ///< of it; none, if it is cleared
  std::size_t command_ = 0;        ///< at hand
  std::uint64_t words_ = 0;        ///< of the command, or header, at hand
  std::uint64_t sent_ = 0;         ///< of these
  std::optional<std::size_t> target_;
  std::uint64_t skipped_ = 0;
  std::size_t turn_ = 0;          ///< port that the frame buffer asks first
  std::uint64_t clear_left_ = 0;  ///< words of background
  std::uint64_t stored_ = 0;
  Time end_ = 0;
};

}  // namespace

void check_countable(const isa::Program& program, const Machine& machine) {
  constexpr std::uint64_t most_tests = std::uint64_t{1} << 36U;
  constexpr std::uint64_t most_clocks = std::uint64_t{1} << 60U;
  const Figures& figures = machines::own<Figures>(machine);
  std::uint64_t clocks = 0;
  for (const isa::Segment& segment : program.segments) {
    const isa::DivisionFacts& tests = segment.facts.division;
    const std::pair<std::uint64_t, std::uint64_t> all[] = {{tests.boxes, figures.box_clocks},
                                                           {tests.group_boxes, figures.box_clocks},
                                                           {tests.halfspaces, figures.halfspace_clocks},
                                                           {tests.group_halfspaces, figures.halfspace_clocks},
                                                           {tests.cells, figures.cell_clocks},
                                                           {tests.group_cells, figures.cell_clocks},
                                                           {tests.nodes, figures.node_clocks}};
    for (const auto& [count, each] : all) {
      clocks += std::min(count, most_tests) * each;
      if (count <= most_tests && clocks <= most_clocks) continue;
      throw InputError(
          fmt::format("the divider would test for more than {} clocks; give it a smaller model, or {} "
                      "fewer clocks a test",
                      most_clocks, machine.name));
    }
  }
}

SquareTiming time_squares(const isa::Program& program, const Machine& machine) {
  return FrameModel(program, machine).run();
}

FrameTiming time_frame(const isa::Program& program, const Machine& machine, std::span<const machines::Skip> /*skips*/) {
  const SquareTiming timing = time_squares(program, machine);
  return {.clocks = timing.clocks, .account = account(timing.account)};
}

}  // namespace csgsim::pixel_square
