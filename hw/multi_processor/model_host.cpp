#include "hw/multi_processor/model_host.h"

#include <algorithm>

namespace csgsim::multi_processor {

ModelHost::ModelHost(sc_core::sc_module_name name, const machines::Machine& machine)
    : sc_core::sc_module(name), time_(machine), link_(machines::kind_figures<Figures>(machine).host) {
  SC_HAS_PROCESS(ModelHost);
  SC_THREAD(work);
}

void ModelHost::begin(std::span<const std::uint8_t> model) {
  model_ = model;
  start_.notify(sc_core::SC_ZERO_TIME);
}

void ModelHost::work() {
  while (true) {
    wait(start_);
    wait(time_.of(link_.latency));
    for (std::uint64_t sent = 0; sent < bits(); sent += link_.width) {
      wait(time_.of(link_.word_clocks));
      word.write({++words_, link_word_at(sent)});
    }
  }
}

isa::LinkWord ModelHost::link_word_at(std::uint64_t first_bit) const {
  isa::LinkWord sent;
  for (std::uint64_t bit = first_bit; bit < std::min(first_bit + link_.width, bits()); ++bit) {
    const std::uint64_t place = bit - length_bits;
    const std::uint64_t value = bit < length_bits
                                    ? model_.size() >> bit
                                    : std::uint64_t{model_[static_cast<std::size_t>(place / 8)]} >> place % 8;
    sent.put(static_cast<unsigned>(bit - first_bit), 1, value & 1U);
  }
  return sent;
}

}  // namespace csgsim::multi_processor
