#include "hw/pixel_square/timing_sender.h"

#include <algorithm>

#include "hw/base/quotient.h"
#include "hw/isa/wire.h"
#include "hw/machines/clocks.h"
#include "hw/pixel_square/timing_division.h"

namespace csgsim::pixel_square {

namespace {

constexpr std::uint64_t header_bits = 64;  ///< of a square on its way to the frame buffer

}  // namespace

SenderTiming::SenderTiming(const isa::Program& program, const machines::Machine& machine,
                           std::vector<RendererTiming>& renderers, Fifo<TimedPortWord>& clears, Agenda& agenda,
                           machines::Timeline* told)
    : program_(program),
      machine_(machine),
      figures_(machines::own<Figures>(machine)),
      has_divider_(figures_.divider != DividerKind::host),
      part_(PartNumbers{renderers.size()}.sender()),
      colour_bits_(isa::frame_header(program).colour.width),
      renderers_(renderers),
      clears_(clears),
      agenda_(agenda),
      told_(told) {}

void SenderTiming::begin() { begin_square(0, has_divider_ ? take_model() : wait_for_host()); }

Time SenderTiming::wait_for_host() {
  const Time first = 1 + machine_.link.latency;
  clocks_.wait(SquareActivity::waiting_for_host, first);
  return first;
}

/// The words of the model follow each other as fast as the host can send and the FIFO take them. Returns the edge
/// after that at which the divider takes the last.
Time SenderTiming::take_model() {
  const std::uint64_t words = quotient_up(8 * std::uint64_t{program_.display_model.size()}, machine_.link.width);
  if (words == 0) return 1;
  const Time spacing = std::max<Time>(machine_.link.word_clocks, machine_.link.fifo_depth == 1 ? 2 : 1);
  const Time sent = machine_.link.latency + machine_.link.word_clocks + (words - 1) * spacing;
  host_.wait(SquareActivity::waiting_for_host, 1 + machine_.link.latency);
  host_.work(words * machine_.link.word_clocks);
  host_.wait(SquareActivity::waiting_for_divider, sent + 1);
  clocks_.work(words);
  clocks_.wait(SquareActivity::waiting_for_host, sent + 2);
  return sent + 2;
}

void SenderTiming::begin_square(std::size_t square, Time now) {
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
  const Time tests = test_clocks(segment.division, figures_);
  clocks_.work(tests);
  ready(now + tests);
}

void SenderTiming::list_commands(const isa::Segment& segment) {
  const std::uint32_t width = machine_.link.width;
  commands_.reserve(segment.instructions.size() + 2);
  commands_.push_back({.kind = CommandKind::start,
                       .words = isa::wire_words(isa::SegmentStart{segment.region}, width),
                       .clocks = std::max<std::uint64_t>(1, machine_.clear_clocks),
                       .told = told_ == nullptr ? nullptr : &told_->cleared[square_]});
  for (std::size_t i = 0; i < segment.instructions.size(); ++i) {
    commands_.push_back({.kind = CommandKind::instruction,
                         .words = isa::wire_words(segment.instructions[i], width),
                         .clocks = machines::bit_serial_clocks(segment.instructions[i], machine_),
                         .told = told_ == nullptr ? nullptr : &told_->issued[square_][i]});
  }
  commands_.push_back({.kind = CommandKind::end,
                       .words = isa::wire_words(isa::SegmentEnd{}, width),
                       .clocks = 1 + std::uint64_t{machines::evaluator_latency(machine_.array)},
                       .colour_words = header_words() + colour_words(segment.region)});
  command_ = 0;
  words_ = commands_.front().words;
}

std::uint64_t SenderTiming::header_words() const { return quotient_up(header_bits, figures_.port_bits); }

std::uint64_t SenderTiming::colour_words(const isa::Region& region) const {
  return quotient_up(std::uint64_t{region.width} * region.height * colour_bits_, figures_.port_bits);
}

/// A word begins to leave.
void SenderTiming::ready(Time now) {
  clocks_.work(word_clocks() - 1);
  agenda_.put(part_, now + word_clocks() - 1);
}

void SenderTiming::send(Time now) {
  if (square_ == program_.segments.size()) return;
  commands_.empty() ? send_header(now) : send_command(now);
}

void SenderTiming::send_header(Time now) {
  if (!clears_.has_room(now)) {
    if (clears_.room_follows()) agenda_.put(part_, now + 1);
    return;
  }
  const bool last = sent_ + 1 == words_;
  clears_.write(now, {last, last ? colour_words(program_.segments[square_].region) : 0});
  clocks_.wait(SquareActivity::waiting_for_frame_buffer, now);
  clocks_.work(1);
  ++sent_;
  if (!last) return ready(now + 1);
  ++skipped_;
  begin_square(square_ + 1, now + 1);
}

void SenderTiming::send_command(Time now) {
  if (!target_) {
    target_ = least_busy(now);
    renderers_[*target_].hand();
  }
  Fifo<TimedLinkWord>& link = renderers_[*target_].link();
  if (!link.has_room(now)) {
    if (link.room_follows()) agenda_.put(part_, now + 1);
    return;
  }
  const bool last = sent_ + 1 == words_;
  link.write(now, {last ? std::optional(commands_[command_]) : std::nullopt});
  clocks_.wait(SquareActivity::waiting_for_renderer, now);
  clocks_.work(1);
  ++sent_;
  if (!last) return ready(now + 1);
  sent_ = 0;
  if (++command_ == commands_.size()) return begin_square(square_ + 1, now + 1);
  words_ = commands_[command_].words;
  ready(now + 1);
}

std::size_t SenderTiming::least_busy(Time now) const {
  const auto best = std::min_element(
      renderers_.begin(), renderers_.end(),
      [now](const RendererTiming& a, const RendererTiming& b) { return a.unfinished(now) < b.unfinished(now); });
  return static_cast<std::size_t>(best - renderers_.begin());
}

}  // namespace csgsim::pixel_square
