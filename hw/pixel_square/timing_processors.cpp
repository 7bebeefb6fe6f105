#include "hw/pixel_square/timing_processors.h"

#include "hw/pixel_square/figures.h"
#include "hw/pixel_square/timing_commands.h"

namespace csgsim::pixel_square {

ProcessorsTiming::ProcessorsTiming(const isa::Program& program, const machines::Machine& machine,
                                   std::vector<RendererTiming>& renderers, Agenda& agenda,
                                   std::span<const machines::Skip> skips, machines::Timeline* timeline)
    : program_(program),
      machine_(machine),
      renderers_(renderers),
      agenda_(agenda),
      skips_(skips),
      timeline_(timeline),
      reservations_(renderers.size()) {
  const Figures& figures = machines::kind_figures<Figures>(machine);
  if (!has_ring(figures)) return;
  const PartNumbers parts{.renderers = renderers.size(), .processors = figures.processors};
  for (std::size_t i = 0; i < figures.processors; ++i) {
    processors_.push_back(
        {.part = parts.processor(i), .words = {figures.port_fifo_depth, parts.processor(i), parts.ring(), agenda}});
  }
}

void ProcessorsTiming::begin() {
  for (const Processor& processor : processors_) agenda_.schedule(processor.part, 1 + machine_.link.latency);
}

void ProcessorsTiming::act(std::size_t processor_index, Time now) {
  Processor& processor = processors_[processor_index];
  if (processor.all_sent) return;
  processor.clocks.count_waiting(processor.activity, now);
  if (!processor.square && !try_take_square(processor)) return sleep(processor, SquareActivity::done);
  if (!processor.commands.empty() && !processor.renderer && !try_request_renderer(processor, now))
    return sleep(processor, SquareActivity::waiting_for_renderer);
  if (!processor.words.has_room(now)) {
    if (processor.words.has_room_next()) agenda_.schedule(processor.part, now + 1);
    return sleep(processor, SquareActivity::waiting_for_ring);
  }
  send(processor, now);
}

bool ProcessorsTiming::try_take_square(Processor& processor) {
  if (next_ == program_.segments.size()) return false;
  processor.square = next_++;
  processor.commands = timed_commands(program_, *processor.square, machine_, skips_, timeline_);
  processor.command = 0;
  processor.sent = 0;
  return true;
}

bool ProcessorsTiming::try_request_renderer(Processor& processor, Time now) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < reservations_.size(); ++i) {
    if (reservations_[i].reserved) continue;
    if (reservations_[i].free_from > now) {
      agenda_.schedule(processor.part, reservations_[i].free_from);
      continue;
    }
    if (!best || renderers_[i].unfinished_squares(now) < renderers_[*best].unfinished_squares(now)) best = i;
  }
  if (!best) return false;
  processor.renderer = best;
  reservations_[*best].reserved = true;
  renderers_[*best].assign();
  return true;
}

void ProcessorsTiming::send(Processor& processor, Time now) {
  const TimedRingWord word = next_word(processor);
  processor.all_sent = word.ends;
  if (word.ends && !word.renderer) ++skipped_;
  processor.words.write(now, word);
  processor.clocks.count_working(1);
  processor.activity = SquareActivity::waiting_for_ring;
  if (!processor.all_sent) agenda_.schedule(processor.part, now + 1);
}

TimedRingWord ProcessorsTiming::next_word(Processor& processor) {
  ++processor.sent;
  if (processor.commands.empty()) {
    const bool last = processor.sent == header_words(colour_word_bits(machines::kind_figures<Figures>(machine_)));
    return {.renderer = std::nullopt,
            .command = {},
            .header = {.last = last, .row = std::nullopt, .cleared = *processor.square},
            .ends = last};
  }
  const TimedCommand& command = processor.commands[processor.command];
  if (processor.sent < command.words) return {.renderer = processor.renderer, .command = {}, .header = {}};
  processor.sent = 0;
  const bool ends = ++processor.command == processor.commands.size();
  return {.renderer = processor.renderer, .command = {command}, .header = {}, .ends = ends};
}

void ProcessorsTiming::leave(std::size_t processor_index, Time now) {
  Processor& processor = processors_[processor_index];
  processor.clocks.count_waiting(SquareActivity::waiting_for_ring, now + 1);
  if (processor.renderer) reservations_[*processor.renderer] = {.reserved = false, .free_from = now + 1};
  processor.renderer.reset();
  processor.square.reset();
  processor.all_sent = false;
  agenda_.schedule(processor.part, now + 1);
  for (const Processor& other : processors_)
    if (other.activity == SquareActivity::waiting_for_renderer) agenda_.wake(other.part, now + 1);
}

}  // namespace csgsim::pixel_square
