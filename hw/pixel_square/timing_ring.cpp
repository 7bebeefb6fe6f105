#include "hw/pixel_square/timing_ring.h"

#include "hw/pixel_square/figures.h"

namespace csgsim::pixel_square {

RingTiming::RingTiming(const machines::Machine& machine, ProcessorsTiming& processors,
                       std::vector<RendererTiming>& renderers, Agenda& agenda)
    : word_clocks_(machines::kind_figures<Figures>(machine).ring_word_clocks),
      banks_(machines::kind_figures<Figures>(machine).banks),
      processors_(processors),
      renderers_(renderers),
      agenda_(agenda),
      part_(PartNumbers{.renderers = renderers.size()}.ring()),
      channels_(machines::kind_figures<Figures>(machine).ring_channels),
      sources_(renderers.size() + processors.count()) {
  const Figures& figures = machines::kind_figures<Figures>(machine);
  if (!has_ring(figures)) return;
  const std::size_t sources = renderers.size() + processors.count();
  if (channels_ == all_channels) channels_ = sources;
  const std::size_t frame_buffer = PartNumbers{.renderers = renderers.size()}.frame_buffer();
  for (std::size_t i = 0; i < sources; ++i) carried_.emplace_back(figures.port_fifo_depth, part_, frame_buffer, agenda);
  for (std::size_t i = 0; i < processors.count(); ++i) processors.words(i).track_in(sources_, i);
  for (std::size_t i = 0; i < renderers.size(); ++i) renderers[i].colours().track_in(sources_, processors.count() + i);
}

/// Sleeps if no word can be carried until another unit acts.
void RingTiming::carry(Time now) {
  if (now % word_clocks_ != 0) return agenda_.schedule(part_, step_after(now));
  const std::size_t sources = processors_.count() + renderers_.size();
  to_frame_buffer_ = 0;
  std::size_t carried = 0;
  bool retry = false;
  sources_.for_each_from(turn_, [&](std::size_t source) {
    const Outcome outcome = carry_from(source, now);
    retry = retry || outcome != Outcome::stuck;
    if (outcome != Outcome::carried) return true;
    turn_ = next_in_turn(source, sources);
    return ++carried < channels_;
  });
  words_ += carried;
  if (carried > 0) {
    clocks_.count_waiting(SquareActivity::waiting_for_divider, now + 1 - word_clocks_);
    clocks_.count_working(word_clocks_);
  }
  if (carried == channels_ || to_frame_buffer_ == banks_) ++full_steps_;
  if (retry) agenda_.schedule(part_, step_after(now));
}

RingTiming::Outcome RingTiming::carry_from(std::size_t source, Time now) {
  return source < processors_.count() ? carry_from_processor(source, now)
                                      : carry_from_renderer(source - processors_.count(), now);
}

namespace {

/// Whether a word can pass between the two FIFOs at this edge (passes), or at a later edge without any other event
/// (will_pass).
template <class From, class To>
bool passes(const Fifo<From>& from, const Fifo<To>& to, Time now) {
  return from.has_word(now) && to.has_room(now);
}

template <class From, class To>
bool will_pass(const Fifo<From>& from, const Fifo<To>& to) {
  return from.has_word_next() && to.has_room_next();
}

}  // namespace

/// A renderer is kept by one processor, so no two processors have words for the same renderer.
RingTiming::Outcome RingTiming::carry_from_processor(std::size_t index, Time now) {
  Fifo<TimedRingWord>& words = processors_.words(index);
  const std::optional<std::size_t> renderer = words.oldest().renderer;
  const bool may_go = renderer || to_frame_buffer_ < banks_;
  const auto pass = [&](auto& to, const auto& word_of) {
    if (!may_go || !passes(words, to, now)) return will_pass(words, to) ? Outcome::later : Outcome::stuck;
    const TimedRingWord word = words.read(now);
    to.write(now, word_of(word));
    if (word.ends) processors_.leave(index, now);
    return Outcome::carried;
  };
  if (renderer) return pass(renderers_[*renderer].link(), [](const TimedRingWord& word) { return word.command; });
  const Outcome outcome =
      pass(carried_[renderers_.size() + index], [](const TimedRingWord& word) { return word.header; });
  if (outcome == Outcome::carried) ++to_frame_buffer_;
  return outcome;
}

RingTiming::Outcome RingTiming::carry_from_renderer(std::size_t index, Time now) {
  Fifo<TimedPortWord>& words = renderers_[index].colours();
  Fifo<TimedPortWord>& to = carried_[index];
  if (to_frame_buffer_ == banks_ || !passes(words, to, now))
    return will_pass(words, to) ? Outcome::later : Outcome::stuck;
  to.write(now, words.read(now));
  ++to_frame_buffer_;
  return Outcome::carried;
}

RingAccount RingTiming::account(Time end) {
  clocks_.count_waiting(SquareActivity::waiting_for_divider, end + 1);
  return {clocks_.complete(end), words_, full_steps_ * word_clocks_};
}

}  // namespace csgsim::pixel_square
