#include "hw/pixel_square/timing.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "hw/base/quotient.h"
#include "hw/isa/opcodes.h"
#include "hw/machines/clocks.h"
#include "hw/pixel_square/account.h"
#include "hw/pixel_square/figures.h"
#include "hw/pixel_square/kind.h"
#include "hw/pixel_square/timing_agenda.h"
#include "hw/pixel_square/timing_divider.h"
#include "hw/pixel_square/timing_division.h"
#include "hw/pixel_square/timing_frame_buffer.h"
#include "hw/pixel_square/timing_processors.h"
#include "hw/pixel_square/timing_renderer.h"
#include "hw/pixel_square/timing_ring.h"
#include "hw/pixel_square/timing_sender.h"

namespace csgsim::pixel_square {

namespace {

using machines::Machine;

std::size_t dividers_in(const Machine& machine) {
  const Figures& figures = machines::kind_figures<Figures>(machine);
  return figures.divider == DividerKind::corners ? figures.dividers : 0;
}

std::size_t processors_in(const Machine& machine) {
  const Figures& figures = machines::kind_figures<Figures>(machine);
  return has_ring(figures) ? figures.processors : 0;
}

/// Edge-level model of the whole machine for one frame: its units act in the order of the agenda.
class FrameModel {
 public:
  FrameModel(const isa::Program& program, const Machine& machine, std::span<const machines::Skip> skips,
             machines::Timeline* timeline)
      : program_(program),
        machine_(machine),
        parts_{machines::kind_figures<Figures>(machine).renderers, dividers_in(machine), processors_in(machine)},
        agenda_(parts_.count()),
        clears_(machines::kind_figures<Figures>(machine).port_fifo_depth, parts_.sender(), parts_.frame_buffer(),
                agenda_),
        renderers_(renderers(program, machine, agenda_)),
        dividers_(dividers(timeline)),
        sender_(program, machine, dividers_, renderers_, clears_, agenda_, skips, timeline),
        processors_(program, machine, renderers_, agenda_, skips, timeline),
        ring_(machine, processors_, renderers_, agenda_),
        frame_buffer_(program, machine, ports(), agenda_) {}

  SquareTiming run() {
    if (!program_.segments.empty()) {
      if (!dividers_.empty()) receive_model();
      has_processors() ? processors_.begin() : sender_.begin();
      while (frame_buffer_.end() == 0) step();
    }
    return {frame_buffer_.end(), frame_account()};
  }

 private:
  static std::vector<RendererTiming> renderers(const isa::Program& program, const Machine& machine, Agenda& agenda) {
    const std::uint32_t colour_bits = isa::frame_header(program).colour.width;
    std::vector<RendererTiming> all;
    for (std::size_t i = 0; i < machines::kind_figures<Figures>(machine).renderers; ++i)
      all.emplace_back(machine, colour_bits, i, agenda);
    return all;
  }

  std::vector<DividerTiming> dividers(machines::Timeline* timeline) {
    std::vector<DividerTiming> all;
    for (std::size_t i = 0; i < parts_.dividers; ++i)
      all.emplace_back(program_, machine_, parts_.divider(i), parts_.sender(), agenda_, timeline);
    if (all.empty()) return all;
    const std::vector<std::size_t> divider_of_square = divider_of_each_square(program_, machine_);
    for (std::size_t square = 0; square < divider_of_square.size(); ++square)
      all[divider_of_square[square]].assign(square);
    return all;
  }

  [[nodiscard]] bool has_processors() const { return parts_.processors > 0; }

  /// Ports of the frame buffer.
  std::vector<Fifo<TimedPortWord>*> ports() {
    std::vector<Fifo<TimedPortWord>*> all;
    for (Fifo<TimedPortWord>& carried : ring_.carried()) all.push_back(&carried);
    if (has_processors()) return all;
    for (RendererTiming& renderer : renderers_) all.push_back(&renderer.colours());
    all.push_back(&clears_);
    return all;
  }

  /// Receives the words of the model as fast as the host can send them and the FIFO has room.
  void receive_model() {
    const machines::Link& link = machine_.link;
    const std::uint64_t words = quotient_up(8 * std::uint64_t{program_.display_model.size()}, link.width);
    Time last = 0;
    if (words > 0) {
      const Time spacing = std::max<Time>(link.word_clocks, link.fifo_depth == 1 ? 2 : 1);
      const Time sent = link.latency + link.word_clocks + (words - 1) * spacing;
      host_.count_waiting(SquareActivity::waiting_for_host, 1 + link.latency);
      host_.count_working(words * link.word_clocks);
      host_.count_waiting(SquareActivity::waiting_for_divider, sent + 1);
      last = sent + 1;
    }
    for (DividerTiming& divider : dividers_) divider.begin(last, words);
  }

  void step() {
    const auto [now, part] = agenda_.next();
    if (part == parts_.frame_buffer()) return frame_buffer_.store(now);
    if (part == parts_.ring()) return ring_.carry(now);
    if (part == parts_.sender()) return sender_.send(now);
    if (part >= parts_.processor(0)) return processors_.act(part - parts_.processor(0), now);
    if (part >= parts_.divider(0)) return dividers_[part - parts_.divider(0)].act(now);
    if (part >= parts_.output(0)) return renderers_[part - parts_.output(0)].leave(now);
    if (part >= parts_.decoder(0)) return renderers_[part - parts_.decoder(0)].decode(now);
    renderers_[part].draw(now);
  }

  SquareAccount frame_account() {
    const Time end = frame_buffer_.end();
    SquareAccount account;
    account.squares_skipped = has_processors() ? processors_.skipped() : sender_.skipped();
    if (has_processors()) {
      for (std::size_t i = 0; i < processors_.count(); ++i) account.processors.push_back(processors_.clocks(i, end));
      account.ring = ring_.account(end);
    } else if (dividers_.empty()) {
      account.host = sender_.clocks(end);
    } else {
      account.host = host_.complete(end);
      account.sender = sender_.clocks(end);
    }
    for (DividerTiming& divider : dividers_) account.dividers.push_back(divider.clocks(end));
    account.frame_buffer = frame_buffer_.clocks(end);
    for (RendererTiming& renderer : renderers_) {
      account.squares_drawn += renderer.finished();
      account.renderers.push_back(renderer.clocks(end));
      account.renderer_squares.push_back(renderer.finished());
    }
    return account;
  }

  const isa::Program& program_;
  const Machine& machine_;
  const PartNumbers parts_;
  Agenda agenda_;
  Fifo<TimedPortWord> clears_;
  std::vector<RendererTiming> renderers_;
  std::vector<DividerTiming> dividers_;
  PartClocks host_;  ///< the host, if the machine has dividers
  SenderTiming sender_;
  ProcessorsTiming processors_;
  RingTiming ring_;
  FrameBufferTiming frame_buffer_;
};

}  // namespace

SquareTiming time_squares(const isa::Program& program, const Machine& machine, std::span<const machines::Skip> skips) {
  return FrameModel(program, machine, skips, nullptr).run();
}

machines::FrameTiming Kind::time(const isa::Program& program, const Machine& machine,
                                 const machines::RunOutcome& outcomes) const {
  const SquareTiming timing = time_squares(program, machine, outcomes.skips);
  return {.clocks = timing.clocks, .account = account(timing.account)};
}

std::optional<machines::Timeline> Kind::timeline(const isa::Program& program, const Machine& machine,
                                                 const machines::RunOutcome& outcomes) const {
  machines::Timeline result = machines::blank_timeline(program);
  FrameModel(program, machine, outcomes.skips, &result).run();
  return result;
}

/// A global-OR test occupies the controller until its answer arrives, but the pixels only for one clock.
std::vector<machines::ClockSpan> Kind::spans_at_pixel(const machines::Timeline& timeline, const isa::Program& program,
                                                      const Machine& machine, std::uint32_t segment,
                                                      std::uint32_t /*x*/, std::uint32_t /*y*/) const {
  std::vector<machines::ClockSpan> spans = timeline.issued[segment];
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const bool needs_global_or = isa::needs_global_or(program.segments[segment].instructions[i].opcode);
    if (needs_global_or && !spans[i].empty()) spans[i].end = spans[i].begin + 1;
  }
  return machines::shifted(std::move(spans), machines::evaluator_latency(machine));
}

}  // namespace csgsim::pixel_square
