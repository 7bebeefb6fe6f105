#pragma once

#include <cstdint>
#include <string_view>
#include <systemc>
#include <vector>

#include "hw/bit_serial_memory/command_queue.h"
#include "hw/link/frame_words.h"
#include "hw/machines/machine.h"

namespace csgsim::bit_serial_memory {

/// The host's end of the link; its memory holds a frame's commands. A request names the instruction at which to resume.
/// The first word is on the link Link::latency clocks after the request, and each word stays there for
/// Link::word_clocks clocks. The words of a command are sent without gaps; a command begins when the queue has room for
/// it.
class HostLink final : public sc_core::sc_module {
 public:
  sc_core::sc_fifo_in<std::uint64_t> requests{"requests"};
  sc_core::sc_port<QueueInput> queue{"queue"};

  HostLink(sc_core::sc_module_name name, const machines::Link& link, const sc_core::sc_time& period);

  /// Loads a frame into the host's memory.
  void load(const link::FrameWords& frame);

  /// Clocks of the frame in which a command was on the link.
  [[nodiscard]] std::uint64_t sending() const { return sending_; }
  [[nodiscard]] std::string_view state() const { return state_; }

 private:
  void work();
  void send_from(std::uint64_t instruction);
  /// Waits for `clocks` clocks, or until a request arrives. Returns false if a request has arrived.
  bool wait_clocks(std::uint64_t clocks);
  bool await_room();
  [[nodiscard]] bool has_request() const { return requests->num_available() > 0; }

  const machines::Link link_;
  const sc_core::sc_time period_;
  std::vector<std::vector<isa::LinkWord>> commands_;
  /// The command at which to resume, for each instruction and for the end of the frame.
  std::vector<std::size_t> begins_;
  std::uint64_t requests_taken_ = 0;  ///< number of requests in this frame
  std::uint64_t sending_ = 0;
  std::string_view state_;
};

}  // namespace csgsim::bit_serial_memory
