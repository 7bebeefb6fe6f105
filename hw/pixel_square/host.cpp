#include "hw/pixel_square/host.h"

namespace csgsim::pixel_square {

using machines::SquareActivity;

Host::Host(sc_core::sc_module_name name, std::uint32_t word_clocks)
    : sc_core::sc_module(name), word_clocks_(word_clocks) {
  SC_HAS_PROCESS(Host);
  SC_METHOD(on_clock);
  dont_initialize();
  sensitive << clock.pos();
}

void Host::begin(std::uint64_t words) {
  words_left_ = words;
  elapsed_ = 0;
  counter_.clear();
}

void Host::on_clock() { counter_.count(act()); }

SquareActivity Host::act() {
  if (words_left_ == 0) return SquareActivity::done;
  if (elapsed_ + 1 < word_clocks_) {
    ++elapsed_;
    return SquareActivity::working;
  }
  if (!model.nb_write({})) return SquareActivity::waiting_for_divider;
  --words_left_;
  elapsed_ = 0;
  return SquareActivity::working;
}

}  // namespace csgsim::pixel_square
