#include "hw/pixel_square/timing_frame_buffer.h"

#include <algorithm>
#include <utility>

#include "hw/pixel_square/figures.h"

namespace csgsim::pixel_square {

FrameBufferTiming::FrameBufferTiming(const isa::Program& program, const machines::Machine& machine,
                                     std::vector<Fifo<TimedPortWord>*> ports, Agenda& agenda)
    : program_(program),
      machine_(machine),
      banks_(machines::kind_figures<Figures>(machine).banks),
      renderers_(machines::kind_figures<Figures>(machine).renderers),
      ports_(std::move(ports)),
      agenda_(agenda),
      screen_(program, machine),
      ready_ports_(ports_.size()),
      clears_(ports_.size() - renderers_) {
  for (std::size_t i = 0; i < ports_.size(); ++i) ports_[i]->track_in(ready_ports_, i);
}

void FrameBufferTiming::store(Time now) {
  const std::size_t ports = ports_.size();
  const std::optional<std::uint32_t> shown = screen_.occupied_bank(now);
  taken_.clear();
  if (shown) taken_.push_back(*shown);
  const std::size_t turns = banks_ - taken_.size();
  std::size_t served = 0;
  bool has_word_next = false;
  ready_ports_.for_each_from(turn_, [&](std::size_t port) {
    const std::optional<TimedPortWord> word = next_port_word(port, now);
    if (word && served < turns && try_claim_bank(*word)) {
      accept_word(port, *word, now);
      ++served;
      turn_ = next_in_turn(port, ports);
    }
    has_word_next = has_word_next || word || ports_[port]->has_word_next();
    return true;
  });
  if (served > 0) {
    clocks_.count_waiting(SquareActivity::waiting_for_renderer, now);
    clocks_.count_working(1);
    if (shown) ++shared_;
  }
  if (served > 0 || has_word_next) agenda_.schedule(PartNumbers{renderers_}.frame_buffer(), now + 1);
}

/// The word that a port can deliver at this edge.
std::optional<TimedPortWord> FrameBufferTiming::next_port_word(std::size_t port, Time now) {
  if (is_clearing(port)) {
    const LeavingSquare& clear = clears_[port - renderers_];
    return TimedPortWord{.last = clear.words_left() == 1, .row = clear.picture_row()};
  }
  if (!ports_[port]->has_word(now)) return std::nullopt;
  return ports_[port]->oldest();
}

/// Claims the word's bank for this clock. Returns false if the bank is already claimed.
bool FrameBufferTiming::try_claim_bank(const TimedPortWord& word) {
  if (!word.row) return true;
  const std::uint32_t bank = *word.row % banks_;
  if (std::ranges::find(taken_, bank) != taken_.end()) return false;
  taken_.push_back(bank);
  return true;
}

void FrameBufferTiming::accept_word(std::size_t port, const TimedPortWord& word, Time now) {
  if (is_clearing(port)) {
    clears_[port - renderers_].advance();
  } else {
    ports_[port]->read(now);
    if (port >= renderers_ && word.last) clears_[port - renderers_] = background_square(word.cleared);
  }
  has_pending(port) ? ready_ports_.add(port) : ready_ports_.remove(port);
  if (word.last && !is_clearing(port) && ++stored_ == program_.segments.size()) end_ = now;
}

/// The words of background for a square.
LeavingSquare FrameBufferTiming::background_square(std::size_t square) const {
  LeavingSquare words(program_.segments[square].region, isa::frame_header(program_).colour.width,
                      colour_word_bits(machines::kind_figures<Figures>(machine_)));
  words.skip_header();
  return words;
}

SquareClocks FrameBufferTiming::clocks(Time end) {
  SquareClocks clocks = clocks_.complete(end);
  const std::uint64_t alone = screen_.clocks_until(end) - shared_;
  clocks.add(SquareActivity::refreshing, alone);
  clocks.clocks[static_cast<std::size_t>(SquareActivity::waiting_for_renderer)] -= alone;
  return clocks;
}

}  // namespace csgsim::pixel_square
