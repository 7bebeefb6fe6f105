#pragma once

#include <deque>
#include <systemc>

#include "hw/bit_serial_memory/row_command.h"

namespace csgsim::bit_serial_memory {

/// Tracks the command that a bank executes, for waves. Commands are added before they begin.
class StartedCommands {
 public:
  /// Adds the next command, which begins at `edge`. It must live until clear().
  void add(const RowCommand& command, const sc_core::sc_time& edge) {
    while (commands_.size() > 1 && commands_[1].edge <= sc_core::sc_time_stamp()) commands_.pop_front();
    commands_.push_back({edge, &command});
  }
  void clear() { commands_.clear(); }

  /// The last command that has begun; null if none has.
  [[nodiscard]] const RowCommand* current() const {
    const RowCommand* last = nullptr;
    for (const Started& one : commands_) {
      if (one.edge > sc_core::sc_time_stamp()) break;
      last = one.command;
    }
    return last;
  }

 private:
  struct Started {
    sc_core::sc_time edge;
    const RowCommand* command = nullptr;
  };

  std::deque<Started> commands_;
};

}  // namespace csgsim::bit_serial_memory
