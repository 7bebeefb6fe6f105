#include "hw/pixel_square/timing_sender.h"

#include <algorithm>

#include "hw/pixel_square/figures.h"
#include "hw/pixel_square/timing_commands.h"
#include "hw/pixel_square/timing_division.h"

namespace csgsim::pixel_square {

SenderTiming::SenderTiming(const isa::Program& program, const machines::Machine& machine,
                           std::vector<DividerTiming>& dividers, std::vector<RendererTiming>& renderers,
                           Fifo<TimedPortWord>& clears, Agenda& agenda, std::span<const machines::Skip> skips,
                           machines::Timeline* timeline)
    : program_(program),
      machine_(machine),
      part_(PartNumbers{renderers.size()}.sender()),
      dividers_(dividers),
      sources_(dividers.empty() ? std::vector<std::size_t>{} : divider_of_each_square(program, machine)),
      renderers_(renderers),
      clears_(clears),
      agenda_(agenda),
      skips_(skips),
      timeline_(timeline),
      activity_(dividers.empty() ? SquareActivity::waiting_for_host : SquareActivity::waiting_for_divider) {}

/// Schedules the host's first word. With dividers, the sender acts at edge 1 and is then woken by their stores.
void SenderTiming::begin() {
  if (!is_host()) return agenda_.schedule(part_, 1);
  clocks_.count_waiting(SquareActivity::waiting_for_host, 1 + machine_.link.latency);
  begin_host_square();
  schedule_next(machine_.link.latency);
}

void SenderTiming::begin_host_square() {
  commands_ = timed_commands(program_, square_, machine_, skips_, timeline_);
  command_ = 0;
  begun_ = true;
  is_clear_ = commands_.empty();
}

/// Returns false if the sender has to wait.
bool SenderTiming::try_begin_square(Time now) {
  if (!store().may_begin(now)) {
    sleep(SquareActivity::waiting_for_divider, store().has_word_next(), now);
    return false;
  }
  begun_ = true;
  is_clear_ = program_.segments[square_].instructions.empty();
  if (is_clear_) store().read(now);
  return true;
}

void SenderTiming::sleep(SquareActivity activity, bool retry_next_edge, Time now) {
  activity_ = activity;
  if (retry_next_edge) agenda_.schedule(part_, now + 1);
}

void SenderTiming::send(Time now) {
  if (square_ == program_.segments.size()) return;
  clocks_.count_waiting(activity_, now);
  if (!begun_ && !try_begin_square(now)) return;
  is_clear_ ? send_header(now) : send_word(now);
}

void SenderTiming::send_header(Time now) {
  if (!clears_.has_room(now)) return sleep(SquareActivity::waiting_for_frame_buffer, clears_.has_room_next(), now);
  const bool last = sent_ + 1 == header_words(machines::kind_figures<Figures>(machine_).port_bits);
  clears_.write(now, {.last = last, .row = std::nullopt, .cleared = square_});
  clocks_.count_working(1);
  ++sent_;
  if (!last) return schedule_next(now);
  ++skipped_;
  end_square(now);
}

void SenderTiming::send_word(Time now) {
  if (!is_host() && !store().has_word(now))
    return sleep(SquareActivity::waiting_for_divider, store().has_word_next(), now);
  if (!target_) {
    target_ = least_busy(now);
    renderers_[*target_].assign();
  }
  Fifo<TimedLinkWord>& link = renderers_[*target_].link();
  if (!link.has_room(now)) return sleep(SquareActivity::waiting_for_renderer, link.has_room_next(), now);
  const TimedStored word = take_word(now);
  link.write(now, {word.whole});
  clocks_.count_working(1);
  word.is_last ? end_square(now) : schedule_next(now);
}

TimedStored SenderTiming::take_word(Time now) {
  if (!is_host()) return store().read(now);
  const TimedCommand& command = commands_[command_];
  if (++sent_ < command.words) return {};
  sent_ = 0;
  return {command, ++command_ == commands_.size()};
}

/// Schedules the next word for the end of the word clocks that follow this edge.
void SenderTiming::schedule_next(Time now) {
  const Time word_clocks = is_host() ? machine_.link.word_clocks : 1;
  clocks_.count_working(word_clocks - 1);
  agenda_.schedule(part_, now + word_clocks);
}

void SenderTiming::end_square(Time now) {
  ++square_;
  begun_ = false;
  sent_ = 0;
  target_.reset();
  if (square_ == program_.segments.size()) return;
  if (is_host()) begin_host_square();
  schedule_next(now);
}

std::size_t SenderTiming::least_busy(Time now) const {
  const auto best =
      std::min_element(renderers_.begin(), renderers_.end(), [now](const RendererTiming& a, const RendererTiming& b) {
        return a.unfinished_squares(now) < b.unfinished_squares(now);
      });
  return static_cast<std::size_t>(best - renderers_.begin());
}

}  // namespace csgsim::pixel_square
