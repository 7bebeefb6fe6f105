#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <systemc>
#include <vector>

#include "hw/machines/machine.h"
#include "hw/multi_processor/account.h"
#include "hw/multi_processor/bus_word.h"
#include "hw/multi_processor/time_base.h"

namespace csgsim::multi_processor {

/// Broadcasts one word at a time to all units. A master that requests the idle bus is granted it after `link.latency`
/// clocks (the lowest number first), and holds it until its last word. A word takes `link.word_clocks` clocks and is on
/// the lines at their end.
class ControlBus final : public sc_core::sc_module {
 public:
  sc_core::sc_vector<sc_core::sc_in<BusRequest>> requests;  ///< one per master
  sc_core::sc_out<BusLines> lines{"lines"};

  ControlBus(sc_core::sc_module_name name, const machines::Machine& machine, std::size_t masters);

  /// Begins the account of a frame.
  void begin();

  [[nodiscard]] BusClocks account() const { return activities_.clocks(time_.now()); }

  /// Shown in waves. The master is the one that holds the bus, if any.
  [[nodiscard]] std::string_view activity() const { return name_of(activities_.now()); }
  [[nodiscard]] std::optional<std::uint32_t> master() const { return master_; }

 private:
  void on_request();
  void on_word();
  void on_grant();
  void start(std::uint32_t master);
  void transfer();
  [[nodiscard]] bool is_requesting(std::uint32_t master) const {
    return requests[master].read().number > served_[master];
  }

  TimeBase time_;
  const machines::Link link_;
  std::vector<std::uint64_t> served_;    ///< number of words of each master
  std::optional<std::uint32_t> master_;  ///< holder of the bus
  bool moving_ = false;                  ///< whether a word or the grant is in transit
  std::uint64_t words_ = 0;
  sc_core::sc_event granted_{"granted"};
  sc_core::sc_event arrived_{"word_arrived"};
  ActivityCounter<BusActivity, bus_activity_names.size()> activities_;
};

}  // namespace csgsim::multi_processor
