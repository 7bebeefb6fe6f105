#include "hw/link/receiver.h"

#include <utility>

#include "hw/link/frame_words.h"

namespace csgsim::link {

isa::Command Receiver::take() { return *std::exchange(command_, std::nullopt); }

void Receiver::clock(sc_core::sc_fifo_in<isa::LinkWord>& link) {
  if (isa::LinkWord word; !command_ && link.nb_read(word)) command_ = decoder_.take(word);
}

void Receiver::drop(sc_core::sc_fifo_in<isa::LinkWord>& link) {
  isa::LinkWord dropped;
  while (link.nb_read(dropped)) continue;
  command_.reset();
  decoder_ = isa::WireDecoder(link_width_);
}

}  // namespace csgsim::link
