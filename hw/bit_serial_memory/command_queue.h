#pragma once

#include <cstdint>
#include <deque>
#include <systemc>
#include <vector>

#include "hw/isa/link_word.h"

namespace csgsim::bit_serial_memory {

/// A command of the host as it comes over the link.
struct LinkedCommand {
  std::vector<isa::LinkWord> words;
  sc_core::sc_time arrived;  ///< edge at which its last word came
};

/// The host's end of the queue.
class QueueInput : virtual public sc_core::sc_interface {
 public:
  [[nodiscard]] virtual bool has_room() const = 0;
  /// A command after the request of that number, the first being 0. One after an earlier request is lost.
  virtual void put(LinkedCommand command, std::uint64_t request) = 0;
  [[nodiscard]] virtual const sc_core::sc_event& room_made() const = 0;
};

/// The controller's end.
class QueueOutput : virtual public sc_core::sc_interface {
 public:
  /// The oldest command, or null.
  [[nodiscard]] virtual const LinkedCommand* front() const = 0;
  virtual LinkedCommand take() = 0;
  /// Everything in it is lost, as the host is asked to go on from elsewhere.
  virtual void flush() = 0;
  [[nodiscard]] virtual const sc_core::sc_event& command_came() const = 0;
};

/// Commands that wait at the controller: as many as there are places.
class CommandQueue final : public sc_core::sc_module, public QueueInput, public QueueOutput {
 public:
  CommandQueue(sc_core::sc_module_name name, std::size_t places) : sc_core::sc_module(name), places_(places) {}

  /// For a new frame.
  void clear() {
    commands_.clear();
    request_ = 0;
  }

  [[nodiscard]] bool has_room() const override { return commands_.size() < places_; }
  void put(LinkedCommand command, std::uint64_t request) override;
  [[nodiscard]] const sc_core::sc_event& room_made() const override { return room_made_; }

  [[nodiscard]] const LinkedCommand* front() const override { return commands_.empty() ? nullptr : &commands_.front(); }
  LinkedCommand take() override;
  void flush() override;
  [[nodiscard]] const sc_core::sc_event& command_came() const override { return command_came_; }

 private:
  const std::size_t places_;
  std::deque<LinkedCommand> commands_;
  std::uint64_t request_ = 0;  ///< the last one
  sc_core::sc_event room_made_{"room_made"};
  sc_core::sc_event command_came_{"command_came"};
};

}  // namespace csgsim::bit_serial_memory
