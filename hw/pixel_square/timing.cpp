#include "hw/pixel_square/timing.h"

#include <vector>

#include "hw/machines/clocks.h"
#include "hw/pixel_square/account.h"
#include "hw/pixel_square/figures.h"
#include "hw/pixel_square/kind.h"
#include "hw/pixel_square/timing_agenda.h"
#include "hw/pixel_square/timing_frame_buffer.h"
#include "hw/pixel_square/timing_renderer.h"
#include "hw/pixel_square/timing_sender.h"

namespace csgsim::pixel_square {

namespace {

using machines::FrameTiming;
using machines::Machine;

/// The machine's parts, and the order in which they act.
class FrameModel {
 public:
  FrameModel(const isa::Program& program, const Machine& machine, machines::Timeline* told)
      : parts_{machines::own<Figures>(machine).renderers},
        has_squares_(!program.segments.empty()),
        agenda_(parts_.count()),
        clears_(machines::own<Figures>(machine).port_fifo_depth, parts_.sender(), parts_.frame_buffer(), agenda_),
        renderers_(renderers(program, machine, agenda_)),
        sender_(program, machine, renderers_, clears_, agenda_, told),
        frame_buffer_(program.segments.size(), renderers_, clears_, agenda_) {}

  SquareTiming run() {
    if (has_squares_) {
      sender_.begin();
      while (frame_buffer_.end() == 0) step();
    }
    return {frame_buffer_.end(), counted()};
  }

 private:
  static std::vector<RendererTiming> renderers(const isa::Program& program, const Machine& machine, Agenda& agenda) {
    const std::uint32_t colour_bits = isa::frame_header(program).colour.width;
    std::vector<RendererTiming> all;
    for (std::size_t i = 0; i < machines::own<Figures>(machine).renderers; ++i)
      all.emplace_back(machine, colour_bits, i, agenda);
    return all;
  }

  void step() {
    const auto [now, part] = agenda_.next();
    if (part == parts_.sender()) return sender_.send(now);
    if (part == parts_.frame_buffer()) return frame_buffer_.store(now);
    const std::size_t number = part % renderers_.size();
    RendererTiming& renderer = renderers_[number];
    if (part == parts_.pixels(number)) return renderer.draw(now);
    if (part == parts_.decoder(number)) return renderer.decode(now);
    renderer.leave(now);
  }

  SquareAccount counted() {
    const Time end = frame_buffer_.end();
    SquareAccount account;
    account.squares_skipped = sender_.skipped();
    account.host = sender_.host_clocks(end);
    account.divider = sender_.divider_clocks(end);
    account.frame_buffer = frame_buffer_.clocks(end);
    for (RendererTiming& renderer : renderers_) {
      account.squares_drawn += renderer.finished();
      account.renderers.push_back(renderer.clocks(end));
      account.renderer_squares.push_back(renderer.finished());
    }
    return account;
  }

  const PartNumbers parts_;
  const bool has_squares_;
  Agenda agenda_;
  Fifo<TimedPortWord> clears_;
  std::vector<RendererTiming> renderers_;
  SenderTiming sender_;
  FrameBufferTiming frame_buffer_;
};

}  // namespace

SquareTiming time_squares(const isa::Program& program, const Machine& machine) {
  return FrameModel(program, machine, nullptr).run();
}

machines::FrameTiming Kind::time(const isa::Program& program, const Machine& machine,
                                 std::span<const machines::Skip> /*skips*/) const {
  const SquareTiming timing = time_squares(program, machine);
  return {.clocks = timing.clocks, .account = account(timing.account)};
}

std::optional<machines::Timeline> Kind::timeline(const isa::Program& program, const Machine& machine,
                                                 std::span<const machines::Skip> /*skips*/) const {
  machines::Timeline told = machines::blank_timeline(program);
  FrameModel(program, machine, &told).run();
  return told;
}

std::vector<machines::ClockSpan> Kind::at_pixel(const machines::Timeline& timeline, const isa::Program& /*program*/,
                                                const Machine& machine, std::uint32_t segment, std::uint32_t /*x*/,
                                                std::uint32_t /*y*/) const {
  return machines::later(timeline.issued[segment], machines::evaluator_latency(machine.array));
}

}  // namespace csgsim::pixel_square
