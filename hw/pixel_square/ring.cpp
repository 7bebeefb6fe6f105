#include "hw/pixel_square/ring.h"

#include <algorithm>

#include "hw/pixel_square/figures.h"
#include "hw/systemc/kernel.h"

namespace csgsim::pixel_square {

namespace {

std::size_t channels_of(const Figures& figures) {
  const std::size_t sources = std::size_t{figures.processors} + figures.renderers;
  return figures.ring_channels == all_channels ? sources : figures.ring_channels;
}

}  // namespace

Ring::Ring(sc_core::sc_module_name name, const machines::Machine& machine)
    : systemc::ClockedModule(name),
      processors("processors", machines::kind_figures<Figures>(machine).processors),
      targets("targets", processors.size()),
      renderers("renderers", machines::kind_figures<Figures>(machine).renderers),
      links("links", renderers.size()),
      colours("colours", renderers.size()),
      clears("clears", processors.size()),
      period_(systemc::period_of(machine)),
      channels_(channels_of(machines::kind_figures<Figures>(machine))),
      word_clocks_(machines::kind_figures<Figures>(machine).ring_word_clocks),
      banks_(machines::kind_figures<Figures>(machine).banks),
      taken_(renderers.size()) {}

void Ring::begin() {
  begun_at_ = edges();
  turn_ = 0;
  clocks_ = {};
  words_ = 0;
  busy_until_ = 0;
  full_clocks_ = 0;
  begun_.notify(sc_core::SC_ZERO_TIME);
}

void Ring::end_of_elaboration() {
  // No range-based loop: clang reports an ambiguous iterator comparison in C++20.
  const auto add = [&](const auto& port) { words_written_ |= port.data_written_event(); };
  std::for_each(processors.begin(), processors.end(), add);
  std::for_each(renderers.begin(), renderers.end(), add);
  words_written_ |= begun_;
}

/// Clock edges since the machine was built.
std::uint64_t Ring::edges() const { return systemc::edges(period_); }

/// Sleeps while all sources are empty.
void Ring::on_clock() {
  if (!clock.posedge()) return;
  if ((edges() - begun_at_) % word_clocks_ == 0) carry();
  if (!has_words()) next_trigger(words_written_);
}

bool Ring::has_words() {
  const auto has_word = [](const auto& port) { return port.num_available() > 0; };
  return std::any_of(processors.begin(), processors.end(), has_word) ||
         std::any_of(renderers.begin(), renderers.end(), has_word);
}

void Ring::carry() {
  taken_.assign(taken_.size(), false);
  frame_buffer_left_ = banks_;
  const std::size_t sources = processors.size() + renderers.size();
  const std::size_t first = turn_;
  std::size_t carried = 0;
  for (std::size_t i = 0; i < sources && carried < channels_; ++i) {
    const std::size_t source = (first + i) % sources;
    if (!try_carry_from(source)) continue;
    ++carried;
    turn_ = (source + 1) % sources;
  }
  words_ += carried;
  if (carried > 0) {
    clocks_.add(SquareActivity::working, word_clocks_);
    busy_until_ = edges() + word_clocks_;
  }
  if (carried == channels_ || frame_buffer_left_ == 0) full_clocks_ += word_clocks_;
}

bool Ring::try_carry_from(std::size_t source) {
  if (source >= processors.size()) return try_carry_colours(source - processors.size());
  if (processors[source].num_available() == 0) return false;
  const std::uint64_t target = targets[source].read();
  return target < renderers.size() ? try_carry_command(source, target) : try_carry_header(source);
}

bool Ring::try_carry_command(std::size_t processor, std::size_t renderer) {
  if (taken_[renderer] || links[renderer].num_free() == 0) return false;
  RingWord word;
  processors[processor].nb_read(word);
  links[renderer].nb_write(word.command);
  taken_[renderer] = true;
  return true;
}

bool Ring::try_carry_header(std::size_t processor) {
  if (frame_buffer_left_ == 0 || clears[processor].num_free() == 0) return false;
  RingWord word;
  processors[processor].nb_read(word);
  clears[processor].nb_write(word.header);
  --frame_buffer_left_;
  return true;
}

bool Ring::try_carry_colours(std::size_t renderer) {
  if (frame_buffer_left_ == 0 || renderers[renderer].num_available() == 0 || colours[renderer].num_free() == 0)
    return false;
  PortWord word;
  renderers[renderer].nb_read(word);
  colours[renderer].nb_write(word);
  --frame_buffer_left_;
  return true;
}

}  // namespace csgsim::pixel_square
