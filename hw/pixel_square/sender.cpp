#include "hw/pixel_square/sender.h"

#include <utility>

#include "hw/base/quotient.h"
#include "hw/pixel_square/figures.h"
#include "hw/systemc/clear_view.h"
#include "hw/systemc/kernel.h"

namespace csgsim::pixel_square {

Sender::Sender(sc_core::sc_module_name name, const machines::Machine& machine, std::uint32_t word_clocks)
    : systemc::ClockedModule(name),
      links("links", machines::kind_figures<Figures>(machine).renderers),
      finished("finished", machines::kind_figures<Figures>(machine).renderers),
      period_(systemc::period_of(machine)),
      word_clocks_(word_clocks),
      port_bits_(machines::kind_figures<Figures>(machine).port_bits),
      assigned_(machines::kind_figures<Figures>(machine).renderers) {}

void Sender::begin_frame(std::size_t squares) {
  squares_ = squares;
  index_ = 0;
  square_.reset();
  skipped_ = 0;
  clocks_ = {};
  status_ = {};
  activity_ = {};
  acted_at_ = systemc::edges(period_);
  begun_.notify(sc_core::SC_ZERO_TIME);
}

/// Sleeps when all squares are sent, and while stalled.
void Sender::on_clock() {
  if (index_ == squares_) {
    status_ = {.state = name_of(SquareActivity::done), .square = squares_, .renderer = std::nullopt};
    return next_trigger(begun_);
  }
  if (!clock.posedge()) return;
  const std::uint64_t now = systemc::edges(period_);
  clocks_.add(activity_, now - std::exchange(acted_at_, now) - 1);
  activity_ = act();
  clocks_.add(activity_);
  sleep();
}

/// Sleeps until the stall can end at the next edge.
void Sender::sleep() {
  if (activity_ == SquareActivity::waiting_for_renderer) return next_trigger(links[*target_].data_read_event());
  if (activity_ == SquareActivity::waiting_for_frame_buffer) return next_trigger(clears.data_read_event());
  if (square_ || activity_ != SquareActivity::waiting_for_divider) return;
  if (const sc_core::sc_event* const event = prepared(index_)) next_trigger(*event);
}

SquareActivity Sender::act() {
  status_ = {.state = preparing(), .square = index_, .renderer = std::nullopt};
  if (!square_) {
    if (const std::optional<SquareActivity> activity = prepare(index_)) return record_state(*activity);
    begin_square();
  }
  status_.state = "sending";
  const SquareActivity activity = send();
  status_.renderer = target_;
  return record_state(activity);
}

SquareActivity Sender::record_state(SquareActivity activity) {
  if (activity != SquareActivity::working) status_.state = name_of(activity);
  return activity;
}

void Sender::begin_square() {
  square_ = start(index_);
  target_.reset();
  sent_ = 0;
  elapsed_ = 0;
}

void Sender::end_square() {
  square_.reset();
  ++index_;
}

SquareActivity Sender::send() {
  if (elapsed_ + 1 < word_clocks_) {
    ++elapsed_;
    return SquareActivity::working;
  }
  const SquareActivity activity = square_->is_clear ? send_header() : send_word();
  if (activity == SquareActivity::working) elapsed_ = 0;
  return activity;
}

SquareActivity Sender::send_header() {
  if (clears.num_free() == 0) return SquareActivity::waiting_for_frame_buffer;
  const std::uint64_t header = header_of(square_->region);
  clears.nb_write({slice_of({&header, 1}, sent_ * port_bits_, port_bits_)});
  if (++sent_ < quotient_up(header_bits, port_bits_)) return SquareActivity::working;
  retirement->after_segment(static_cast<std::uint32_t>(index_), systemc::ClearView());
  ++skipped_;
  end_square();
  return SquareActivity::working;
}

/// The renderer is chosen when the first word is ready to leave.
SquareActivity Sender::send_word() {
  const isa::LinkWord* const word = next_word();
  if (word == nullptr) return SquareActivity::waiting_for_divider;
  if (!target_) {
    target_ = least_busy();
    ++assigned_[*target_];
  }
  if (!links[*target_].nb_write(*word)) return SquareActivity::waiting_for_renderer;
  if (advance()) end_square();
  return SquareActivity::working;
}

std::size_t Sender::least_busy() const {
  std::size_t best = 0;
  const auto unfinished = [&](std::size_t renderer) { return assigned_[renderer] - finished[renderer].read(); };
  for (std::size_t renderer = 1; renderer < assigned_.size(); ++renderer) {
    if (unfinished(renderer) < unfinished(best)) best = renderer;
  }
  return best;
}

}  // namespace csgsim::pixel_square
