#pragma once

#include <cstdint>
#include <deque>
#include <systemc>
#include <vector>

#include "hw/isa/link_word.h"

namespace csgsim::bit_serial_memory {

/// A host command received over the link.
struct LinkedCommand {
  std::vector<isa::LinkWord> words;
  sc_core::sc_time arrived;  ///< edge at which its last word arrived
};

/// The host's side of the queue.
class QueueInput : virtual public sc_core::sc_interface {
 public:
  [[nodiscard]] virtual bool has_room() const = 0;
  /// Appends a command that the host sent for request number `request`, counted from 0. A command of an earlier request
  /// is dropped.
  virtual void put(LinkedCommand command, std::uint64_t request) = 0;
  [[nodiscard]] virtual const sc_core::sc_event& room_made() const = 0;
};

/// The controller's side of the queue.
class QueueOutput : virtual public sc_core::sc_interface {
 public:
  /// The oldest command, or null.
  [[nodiscard]] virtual const LinkedCommand* front() const = 0;
  virtual LinkedCommand take() = 0;
  /// Drops all commands, because the host has been requested to resume at another instruction.
  virtual void flush() = 0;
  [[nodiscard]] virtual const sc_core::sc_event& command_arrived() const = 0;
};

/// Commands that wait at the controller, up to the capacity.
class CommandQueue final : public sc_core::sc_module, public QueueInput, public QueueOutput {
 public:
  CommandQueue(sc_core::sc_module_name name, std::size_t capacity) : sc_core::sc_module(name), capacity_(capacity) {}

  /// Prepares for a new frame.
  void clear() {
    commands_.clear();
    request_ = 0;
  }

  [[nodiscard]] bool has_room() const override { return commands_.size() < capacity_; }
  void put(LinkedCommand command, std::uint64_t request) override;
  [[nodiscard]] const sc_core::sc_event& room_made() const override { return room_made_; }

  [[nodiscard]] const LinkedCommand* front() const override { return commands_.empty() ? nullptr : &commands_.front(); }
  LinkedCommand take() override;
  void flush() override;
  [[nodiscard]] const sc_core::sc_event& command_arrived() const override { return command_arrived_; }

 private:
  const std::size_t capacity_;
  std::deque<LinkedCommand> commands_;
  std::uint64_t request_ = 0;  ///< number of the last request
  sc_core::sc_event room_made_{"room_made"};
  sc_core::sc_event command_arrived_{"command_came"};
};

}  // namespace csgsim::bit_serial_memory
