#pragma once

#include <deque>
#include <systemc>

#include "hw/bit_serial_memory/row_command.h"

namespace csgsim::bit_serial_memory {

/// Which command a bank is at, for waves: it is told some before they begin.
class BegunCommands {
 public:
  /// The next, which begins at that edge. It has to live until they are cleared.
  void add(const RowCommand& command, const sc_core::sc_time& edge) {
    while (commands_.size() > 1 && commands_[1].edge <= sc_core::sc_time_stamp()) commands_.pop_front();
    commands_.push_back({edge, &command});
  }
  void clear() { commands_.clear(); }

  /// The last that has begun, or none.
  [[nodiscard]] const RowCommand* current() const {
    const RowCommand* last = nullptr;
    for (const Begun& one : commands_) {
      if (one.edge > sc_core::sc_time_stamp()) break;
      last = one.command;
    }
    return last;
  }

 private:
  struct Begun {
    sc_core::sc_time edge;
    const RowCommand* command = nullptr;
  };

  std::deque<Begun> commands_;
};

}  // namespace csgsim::bit_serial_memory
