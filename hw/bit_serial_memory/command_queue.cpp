#include "hw/bit_serial_memory/command_queue.h"

#include <utility>

namespace csgsim::bit_serial_memory {

void CommandQueue::put(LinkedCommand command, std::uint64_t request) {
  if (request != request_) return;
  commands_.push_back(std::move(command));
  command_arrived_.notify(sc_core::SC_ZERO_TIME);
}

LinkedCommand CommandQueue::take() {
  LinkedCommand command = std::move(commands_.front());
  commands_.pop_front();
  room_made_.notify(sc_core::SC_ZERO_TIME);
  return command;
}

void CommandQueue::flush() {
  commands_.clear();
  ++request_;
  room_made_.notify(sc_core::SC_ZERO_TIME);
}

}  // namespace csgsim::bit_serial_memory
