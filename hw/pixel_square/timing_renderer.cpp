#include "hw/pixel_square/timing_renderer.h"

#include <algorithm>
#include <utility>

#include "hw/base/quotient.h"
#include "hw/machines/clocks.h"
#include "hw/pixel_square/figures.h"

namespace csgsim::pixel_square {

namespace {

/// Clock 0 of a timeline begins at the first edge after the frame is requested. A command that the pixels take at this
/// edge is accounted for from edge 2 on.
constexpr Time first_edge = 2;

PartNumbers numbers(const machines::Machine& machine) { return {machines::kind_figures<Figures>(machine).renderers}; }

/// Number of the unit that delivers commands.
std::size_t command_source(const machines::Machine& machine) {
  return has_ring(machines::kind_figures<Figures>(machine)) ? numbers(machine).ring() : numbers(machine).sender();
}

/// Number of the unit that receives colours.
std::size_t colour_sink(const machines::Machine& machine) {
  return has_ring(machines::kind_figures<Figures>(machine)) ? numbers(machine).ring() : numbers(machine).frame_buffer();
}

Time latch_clocks(const Figures& figures, std::uint32_t colour_bits) {
  const bool latches = figures.buffers < 2 && figures.backing_bits == no_backing && figures.latch_bits != no_latch;
  return latches ? quotient_up(colour_bits, figures.latch_bits) : 0;
}

/// Clocks to move a finished square from the pixels to its buffer.
Time move_clocks(const machines::Machine& machine, std::uint32_t colour_bits) {
  const Figures& figures = machines::kind_figures<Figures>(machine);
  if (figures.backing_bits != no_backing) {
    const Time square = Time{machine.array.width} * machine.array.height * colour_bits;
    return figures.backing_width == all_planes ? 0 : quotient_up(square, Time{figures.backing_width});
  }
  return figures.move_bits == all_planes ? 0 : quotient_up(colour_bits, figures.move_bits);
}

}  // namespace

RendererTiming::RendererTiming(const machines::Machine& machine, std::uint32_t colour_bits, std::size_t renderer,
                               Agenda& agenda)
    : agenda_(&agenda),
      pixels_(numbers(machine).pixels(renderer)),
      decoder_(numbers(machine).decoder(renderer)),
      output_(numbers(machine).output(renderer)),
      waiting_(waiting_square_capacity(machines::kind_figures<Figures>(machine), colour_bits)),
      latency_(machines::evaluator_latency(machine)),
      colour_bits_(colour_bits),
      port_bits_(colour_word_bits(machines::kind_figures<Figures>(machine))),
      move_clocks_(move_clocks(machine, colour_bits)),
      latch_clocks_(latch_clocks(machines::kind_figures<Figures>(machine), colour_bits)),
      link_(machine.link.fifo_depth, command_source(machine), decoder_, agenda),
      colours_(machines::kind_figures<Figures>(machine).port_fifo_depth, output_, colour_sink(machine), agenda) {}

void RendererTiming::decode(Time now) {
  if (command_) return;
  if (!link_.has_word(now)) {
    if (link_.has_word_next()) agenda_->schedule(decoder_, now + 1);
    return;
  }
  command_ = link_.read(now).whole;
  command_ ? agenda_->wake(pixels_, now + 1) : agenda_->schedule(decoder_, now + 1);
}

void RendererTiming::draw(Time now) {
  if (moving_) return finish(now);
  if (drawn_) return move_out(now);
  if (leaving_ || !command_) return;
  if (skips_left_ > 0) {
    --skips_left_;
    command_.reset();
    return agenda_->wake(decoder_, now);
  }
  clocks_.count_waiting(SquareActivity::waiting_for_divider, now);
  execute(*std::exchange(command_, std::nullopt), now);
}

void RendererTiming::execute(const TimedCommand& command, Time now) {
  agenda_->wake(decoder_, now);
  clocks_.count_working(command.clocks);
  if (command.span != nullptr) *command.span = {now - first_edge, now - first_edge + command.clocks};
  skips_left_ = command.skips;
  if (command.kind == CommandKind::end) {
    drawn_ = LeavingSquare(*command.region, colour_bits_, port_bits_);
    return agenda_->schedule(pixels_, now + latency_);
  }
  agenda_->schedule(pixels_, now + command.clocks);
}

/// A drawn square leaves the pixels when the buffer has room; a square that left at an earlier edge frees an entry.
void RendererTiming::move_out(Time now) {
  const std::uint64_t room = std::max<std::uint64_t>(waiting_, 1);
  if (squares_.size() >= room) return;
  if (left_ == now && squares_.size() + 1 >= room) return agenda_->schedule(pixels_, now + 1);
  squares_.push_back(*std::exchange(drawn_, std::nullopt));
  latch_ = latch_clocks_ > 0 ? std::optional(RowLatch(latch_clocks_, now)) : std::nullopt;
  clocks_.count_waiting(SquareActivity::waiting_for_frame_buffer, now + 1);
  if (waiting_ == 0) {
    leaving_ = true;
    return agenda_->schedule(output_, now + 1);
  }
  moving_ = true;
  if (move_clocks_ == 0) return finish(now);
  clocks_.count_working(move_clocks_);
  agenda_->schedule(pixels_, now + move_clocks_);
}

/// The pixels are free from the next edge on.
void RendererTiming::finish(Time now) {
  if (leaving_) {
    clocks_.count_waiting(SquareActivity::waiting_for_frame_buffer, now + 1);
  } else {
    whole_at_ = now;
    agenda_->wake(output_, now + 1);
  }
  moving_ = false;
  leaving_ = false;
  ++finished_;
  finished_at_ = now;
  agenda_->schedule(pixels_, now + 1);
}

void RendererTiming::leave(Time now) {
  if (squares_.empty() || (moving_ && squares_.size() == 1)) return;
  if (whole_at_ == now && squares_.size() == 1) return agenda_->schedule(output_, now + 1);
  LeavingSquare& square = squares_.front();
  const std::optional<LeavingSquare::Rows> rows = latch_ ? square.rows() : std::nullopt;
  if (rows) {
    const Time edge = latch_->transfer_edge(rows->last);
    if (edge > now) return agenda_->schedule(output_, edge);
  }
  if (!colours_.has_room(now)) {
    if (colours_.has_room_next()) agenda_->schedule(output_, now + 1);
    return;
  }
  colours_.write(now, {.last = square.words_left() == 1, .row = square.picture_row()});
  if (rows) latch_->record_word(now);
  square.advance();
  if (square.words_left() > 0) return agenda_->schedule(output_, now + 1);
  squares_.pop_front();
  left_ = now;
  if (leaving_) return finish(now);
  if (!squares_.empty()) agenda_->schedule(output_, now + 1);
  if (drawn_) agenda_->wake(pixels_, now + 1);
}

}  // namespace csgsim::pixel_square
