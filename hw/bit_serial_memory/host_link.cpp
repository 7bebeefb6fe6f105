#include "hw/bit_serial_memory/host_link.h"

#include <algorithm>

#include "hw/isa/wire.h"
#include "hw/systemc/kernel.h"

namespace csgsim::bit_serial_memory {

HostLink::HostLink(sc_core::sc_module_name name, const machines::Link& link, const sc_core::sc_time& period)
    : sc_core::sc_module(name), link_(link), period_(period) {
  SC_HAS_PROCESS(HostLink);
  SC_THREAD(work);
}

void HostLink::load(const link::FrameWords& frame) {
  commands_.clear();
  isa::WireDecoder decoder(link_.width);
  std::vector<std::size_t> first_words;
  for (std::size_t word = 0; word < frame.words.size(); ++word) {
    if (decoder.is_between_commands()) {
      commands_.emplace_back();
      first_words.push_back(word);
    }
    commands_.back().push_back(frame.words[word]);
    decoder.take(frame.words[word]);
  }
  begins_.clear();
  for (const std::size_t word : frame.begins)
    begins_.push_back(static_cast<std::size_t>(std::ranges::lower_bound(first_words, word) - first_words.begin()));
  requests_taken_ = 0;
  sending_ = 0;
}

void HostLink::work() {
  while (true) {
    state_ = "";
    if (!has_request()) wait(requests->data_written_event());
    std::uint64_t instruction = 0;
    requests->nb_read(instruction);
    ++requests_taken_;
    send_from(instruction);
  }
}

bool HostLink::wait_clocks(std::uint64_t clocks) {
  if (clocks > 0 && !has_request()) wait(static_cast<double>(clocks) * period_, requests->data_written_event());
  return !has_request();
}

bool HostLink::await_room() {
  while (!queue->has_room() && !has_request()) wait(queue->room_made() | requests->data_written_event());
  return !has_request();
}

void HostLink::send_from(std::uint64_t instruction) {
  state_ = "waiting";
  if (!wait_clocks(link_.latency)) return;
  const std::size_t first = instruction == 0 ? 0 : begins_[instruction];
  for (std::size_t i = first; i < commands_.size(); ++i) {
    state_ = "blocked";
    if (!await_room()) return;
    state_ = "sending";
    const sc_core::sc_time start_time = systemc::now();
    const bool whole = wait_clocks(commands_[i].size() * std::uint64_t{link_.word_clocks});
    sending_ += (sc_core::sc_time_stamp() - start_time).value() / period_.value();
    if (!whole) return;
    queue->put({commands_[i], sc_core::sc_time_stamp()}, requests_taken_ - 1);
  }
}

}  // namespace csgsim::bit_serial_memory
