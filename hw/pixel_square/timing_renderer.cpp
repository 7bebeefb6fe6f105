#include "hw/pixel_square/timing_renderer.h"

#include <utility>

#include "hw/base/quotient.h"
#include "hw/machines/clocks.h"
#include "hw/pixel_square/figures.h"

namespace csgsim::pixel_square {

namespace {

/// What the pixels begin with at the first edge after the frame was asked for, where clock 0 of a timeline begins, they
/// are accounted for from this time on.
constexpr Time first_edge = 2;

PartNumbers numbers(const machines::Machine& machine) { return {machines::own<Figures>(machine).renderers}; }

/// What brings commands.
std::size_t before(const machines::Machine& machine) {
  return has_ring(machines::own<Figures>(machine)) ? numbers(machine).ring() : numbers(machine).sender();
}

/// What takes colours.
std::size_t behind(const machines::Machine& machine) {
  return has_ring(machines::own<Figures>(machine)) ? numbers(machine).ring() : numbers(machine).frame_buffer();
}

Time latch_clocks(const Figures& figures, std::uint32_t colour_bits) {
  const bool latches = figures.buffers < 2 && figures.latch_bits != no_latch;
  return latches ? quotient_up(colour_bits, figures.latch_bits) : 0;
}

Time move_clocks(const Figures& figures, std::uint32_t colour_bits) {
  return figures.move_bits == all_planes ? 0 : quotient_up(colour_bits, figures.move_bits);
}

}  // namespace

RendererTiming::RendererTiming(const machines::Machine& machine, std::uint32_t colour_bits, std::size_t renderer,
                               Agenda& agenda)
    : agenda_(&agenda),
      pixels_(numbers(machine).pixels(renderer)),
      decoder_(numbers(machine).decoder(renderer)),
      output_(numbers(machine).output(renderer)),
      buffered_(machines::own<Figures>(machine).buffers >= 2),
      latency_(machines::evaluator_latency(machine.array)),
      colour_bits_(colour_bits),
      port_bits_(colour_word_bits(machines::own<Figures>(machine))),
      move_clocks_(move_clocks(machines::own<Figures>(machine), colour_bits)),
      latch_clocks_(latch_clocks(machines::own<Figures>(machine), colour_bits)),
      link_(machine.link.fifo_depth, before(machine), decoder_, agenda),
      colours_(machines::own<Figures>(machine).port_fifo_depth, output_, behind(machine), agenda) {}

void RendererTiming::decode(Time now) {
  if (command_) return;
  if (!link_.has_word(now)) {
    if (link_.word_follows()) agenda_->put(decoder_, now + 1);
    return;
  }
  command_ = link_.read(now).whole;
  command_ ? agenda_->wake(pixels_, now + 1) : agenda_->put(decoder_, now + 1);
}

void RendererTiming::draw(Time now) {
  if (moving_) return finish(now);
  if (drawn_) return move_out(now);
  if (leaving_ || !command_) return;
  clocks_.wait(SquareActivity::waiting_for_divider, now);
  obey(*std::exchange(command_, std::nullopt), now);
}

void RendererTiming::obey(const TimedCommand& command, Time now) {
  agenda_->wake(decoder_, now);
  clocks_.work(command.clocks);
  if (command.told != nullptr) *command.told = {now - first_edge, now - first_edge + command.clocks};
  if (command.kind == CommandKind::end) {
    drawn_ = LeavingSquare(*command.region, colour_bits_, port_bits_);
    return agenda_->put(pixels_, now + latency_);
  }
  agenda_->put(pixels_, now + command.clocks);
}

/// A drawn square leaves the pixels when the one before it has left at an earlier edge.
void RendererTiming::move_out(Time now) {
  if (square_.words_left() > 0) return;
  if (left_ == now) return agenda_->put(pixels_, now + 1);
  square_ = *std::exchange(drawn_, std::nullopt);
  latch_ = latch_clocks_ > 0 ? std::optional(RowLatch(latch_clocks_, now)) : std::nullopt;
  clocks_.wait(SquareActivity::waiting_for_frame_buffer, now + 1);
  if (!buffered_) {
    leaving_ = true;
    return agenda_->put(output_, now + 1);
  }
  moving_ = true;
  if (move_clocks_ == 0) return finish(now);
  clocks_.work(move_clocks_);
  agenda_->put(pixels_, now + move_clocks_);
}

/// The pixels are free from the next edge on.
void RendererTiming::finish(Time now) {
  if (leaving_) {
    clocks_.wait(SquareActivity::waiting_for_frame_buffer, now + 1);
  } else {
    agenda_->put(output_, now + 1);
  }
  moving_ = false;
  leaving_ = false;
  ++finished_;
  finished_at_ = now;
  agenda_->put(pixels_, now + 1);
}

void RendererTiming::leave(Time now) {
  if (square_.words_left() == 0 || moving_) return;
  const std::optional<LeavingSquare::Rows> rows = square_.rows();
  if (latch_ && rows) {
    const Time there = latch_->there(rows->last);
    if (there > now) return agenda_->put(output_, there);
  }
  if (!colours_.has_room(now)) {
    if (colours_.room_follows()) agenda_->put(output_, now + 1);
    return;
  }
  colours_.write(now, {.last = square_.words_left() == 1, .row = square_.picture_row()});
  if (latch_ && rows) latch_->pass(now);
  square_.advance();
  if (square_.words_left() > 0) return agenda_->put(output_, now + 1);
  left_ = now;
  if (leaving_) return finish(now);
  if (drawn_) agenda_->wake(pixels_, now + 1);
}

}  // namespace csgsim::pixel_square
