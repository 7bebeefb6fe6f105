#include "hw/pixel_square/model_receiver.h"

namespace csgsim::pixel_square {

namespace {

constexpr unsigned byte_bits = 8;

}  // namespace

void ModelReceiver::begin(std::uint64_t bytes) {
  bytes_.assign(static_cast<std::size_t>(bytes), {});
  bits_ = 0;
  clocks_ = {};
  begun_.notify(sc_core::SC_ZERO_TIME);
}

/// Sleeps once the model is complete.
void ModelReceiver::on_clock() {
  if (bits_ == byte_bits * bytes_.size()) return next_trigger(begun_);
  if (!clock.posedge()) return;
  clocks_.add(act());
  if (bits_ == byte_bits * bytes_.size()) received_.notify();
}

SquareActivity ModelReceiver::act() {
  isa::LinkWord word;
  if (!model.nb_read(word)) return SquareActivity::waiting_for_host;
  for (unsigned i = 0; i < link_width_ && bits_ < byte_bits * bytes_.size(); ++i, ++bits_) {
    bytes_[static_cast<std::size_t>(bits_ / byte_bits)].put(static_cast<unsigned>(bits_ % byte_bits), 1,
                                                            word.number(i, 1));
  }
  return SquareActivity::working;
}

}  // namespace csgsim::pixel_square
