#include "hw/pixel_square/model_source.h"

namespace csgsim::pixel_square {

ModelSource::ModelSource(sc_core::sc_module_name name, const machines::Link& link)
    : systemc::ClockedModule(name), link_(link) {}

void ModelSource::begin(std::span<const std::uint8_t> model) {
  model_ = model;
  sent_ = 0;
  latency_left_ = link_.latency;
  elapsed_ = 0;
  clocks_ = {};
  state_ = {};
  begun_.notify(sc_core::SC_ZERO_TIME);
}

/// Sleeps when the whole model is sent.
void ModelSource::on_clock() {
  if (done()) {
    state_ = name_of(SquareActivity::done);
    return next_trigger(begun_);
  }
  if (!clock.posedge()) return;
  const SquareActivity activity = act();
  clocks_.add(activity);
  state_ = activity == SquareActivity::working ? "sending" : name_of(activity);
}

SquareActivity ModelSource::act() {
  if (latency_left_ > 0) {
    --latency_left_;
    return SquareActivity::waiting_for_host;
  }
  if (elapsed_ + 1 < link_.word_clocks) {
    ++elapsed_;
    return SquareActivity::working;
  }
  if (words.num_free() == 0) return SquareActivity::waiting_for_divider;
  words.nb_write(next_word());
  sent_ += link_.width;
  elapsed_ = 0;
  return SquareActivity::working;
}

isa::LinkWord ModelSource::next_word() const {
  isa::LinkWord word;
  for (unsigned i = 0; i < link_.width && sent_ + i < 8 * std::uint64_t{model_.size()}; ++i) {
    const std::uint64_t bit = sent_ + i;
    const std::uint64_t byte = model_[static_cast<std::size_t>(bit / 8)];
    word.put(i, 1, byte >> (bit % 8) & 1U);
  }
  return word;
}

}  // namespace csgsim::pixel_square
