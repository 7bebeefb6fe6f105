#include "hw/pixel_square/graphics_processors.h"

#include <algorithm>
#include <utility>

#include "hw/base/quotient.h"
#include "hw/pixel_square/commands.h"
#include "hw/pixel_square/figures.h"
#include "hw/systemc/clear_view.h"
#include "hw/systemc/kernel.h"

namespace csgsim::pixel_square {

GraphicsProcessors::GraphicsProcessors(sc_core::sc_module_name name, const machines::Machine& machine)
    : systemc::ClockedModule(name),
      words("words", machines::kind_figures<Figures>(machine).processors),
      targets("targets", words.size()),
      finished("finished", machines::kind_figures<Figures>(machine).renderers),
      period_(systemc::period_of(machine)),
      word_bits_(machines::kind_figures<Figures>(machine).ring_bits),
      latency_(machine.link.latency),
      fifo_depth_(machines::kind_figures<Figures>(machine).port_fifo_depth),
      processors_(words.size()),
      reserved_(finished.size()),
      assigned_(finished.size()) {}

void GraphicsProcessors::begin(std::span<const isa::Segment> segments) {
  segments_ = segments;
  next_ = 0;
  latency_left_ = latency_;
  std::ranges::fill(processors_, Processor{});
  reserved_.assign(reserved_.size(), false);
  skipped_ = 0;
  acted_at_ = systemc::edges(period_);
  begun_.notify(sc_core::SC_ZERO_TIME);
}

bool GraphicsProcessors::all_done() const {
  return next_ == segments_.size() &&
         std::ranges::none_of(processors_, [](const Processor& processor) { return processor.square.has_value(); });
}

void GraphicsProcessors::end_of_elaboration() {
  // No range-based loop: clang reports an ambiguous iterator comparison in C++20.
  std::for_each(words.begin(), words.end(), [&](const auto& port) { words_taken_ |= port.data_read_event(); });
  words_taken_ |= begun_;
}

/// Whether every processor is stalled or done. A stall can end only when the ring takes a word.
bool GraphicsProcessors::all_stalled() const {
  using enum SquareActivity;
  return std::ranges::all_of(processors_, [](const Processor& one) {
    return one.activity == waiting_for_ring || one.activity == waiting_for_renderer || one.activity == done;
  });
}

/// Sleeps while every processor is stalled, and when all are done.
void GraphicsProcessors::on_clock() {
  if (all_done()) return next_trigger(begun_);
  if (!clock.posedge()) return;
  const std::uint64_t now = systemc::edges(period_);
  const std::uint64_t slept = now - std::exchange(acted_at_, now) - 1;
  for (Processor& processor : processors_) processor.clocks.add(processor.activity, slept);
  for (std::size_t i = 0; i < processors_.size(); ++i) release_renderer(i);
  for (std::size_t i = 0; i < processors_.size(); ++i) record_activity(i, act_processor(i));
  if (latency_left_ > 0) --latency_left_;
  if (all_stalled()) next_trigger(words_taken_);
}

/// Releases the square and the renderer of a processor whose words have all left.
void GraphicsProcessors::release_renderer(std::size_t processor_index) {
  Processor& processor = processors_[processor_index];
  if (!processor.all_sent || static_cast<std::size_t>(words[processor_index].num_free()) < fifo_depth_) return;
  if (processor.renderer) reserved_[*processor.renderer] = false;
  processor.renderer.reset();
  processor.square.reset();
  processor.all_sent = false;
}

SquareActivity GraphicsProcessors::act_processor(std::size_t processor_index) {
  Processor& processor = processors_[processor_index];
  if (latency_left_ > 0) return SquareActivity::waiting_for_host;
  if (processor.all_sent) return SquareActivity::waiting_for_ring;
  if (!processor.square && !try_take_square(processor)) return SquareActivity::done;
  if (!processor.is_clear && !processor.renderer && !try_request_renderer(processor))
    return SquareActivity::waiting_for_renderer;
  if (words[processor_index].num_free() == 0) return SquareActivity::waiting_for_ring;
  send_word(processor_index);
  return SquareActivity::working;
}

bool GraphicsProcessors::try_take_square(Processor& processor) {
  if (next_ == segments_.size()) return false;
  const isa::Segment& segment = segments_[next_];
  processor.square = next_++;
  processor.commands = encode_square(segment.region, segment.instructions, word_bits_);
  processor.is_clear = processor.commands.empty();
  processor.sent = 0;
  return true;
}

bool GraphicsProcessors::try_request_renderer(Processor& processor) {
  const auto unfinished = [&](std::size_t renderer) { return assigned_[renderer] - finished[renderer].read(); };
  for (std::size_t i = 0; i < reserved_.size(); ++i) {
    if (reserved_[i] || (processor.renderer && unfinished(i) >= unfinished(*processor.renderer))) continue;
    processor.renderer = i;
  }
  if (!processor.renderer) return false;
  reserved_[*processor.renderer] = true;
  ++assigned_[*processor.renderer];
  return true;
}

RingWord GraphicsProcessors::next_word(const Processor& processor) const {
  if (!processor.is_clear) return {processor.commands[processor.sent], {}};
  const std::uint64_t header = header_of(segments_[*processor.square].region);
  return {{}, {slice_of({&header, 1}, processor.sent * word_bits_, word_bits_)}};
}

void GraphicsProcessors::send_word(std::size_t processor_index) {
  Processor& processor = processors_[processor_index];
  targets[processor_index].write(processor.renderer.value_or(finished.size()));
  words[processor_index].nb_write(next_word(processor));
  const std::size_t all = processor.is_clear ? quotient_up(header_bits, word_bits_) : processor.commands.size();
  processor.all_sent = ++processor.sent == all;
  if (!processor.all_sent || !processor.is_clear) return;
  retirement->after_segment(static_cast<std::uint32_t>(*processor.square), systemc::ClearView());
  ++skipped_;
}

void GraphicsProcessors::record_activity(std::size_t processor_index, SquareActivity activity) {
  Processor& processor = processors_[processor_index];
  processor.activity = activity;
  processor.clocks.add(activity);
  processor.status = {.state = activity == SquareActivity::working ? "sending" : name_of(activity),
                      .square = processor.square.value_or(segments_.size()),
                      .renderer = processor.renderer};
}

}  // namespace csgsim::pixel_square
