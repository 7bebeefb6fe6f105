// A clock without level changes.
// Used by hw/pixel_planes, hw/pixel_square and hw/scan_line.
#pragma once

#include <systemc>

namespace csgsim::systemc {

/// Clock of a machine whose parts all act on rising edges; the first edge comes one period after the start. The level
/// of the wire is not modelled, so a period takes only one kernel event.
class Clock final : public sc_core::sc_module, public sc_core::sc_signal_in_if<bool> {
 public:
  Clock(sc_core::sc_module_name name, const sc_core::sc_time& period);

  [[nodiscard]] const sc_core::sc_time& period() const { return period_; }

  const sc_core::sc_event& default_event() const override { return edge_; }
  const sc_core::sc_event& value_changed_event() const override { return edge_; }
  const sc_core::sc_event& posedge_event() const override { return edge_; }
  /// Throws std::logic_error.
  const sc_core::sc_event& negedge_event() const override;
  const bool& read() const override { return level_; }
  const bool& get_data_ref() const override { return level_; }
  bool event() const override { return edge_.triggered(); }
  bool posedge() const override { return edge_.triggered(); }
  bool negedge() const override { return false; }

 private:
  void tick();

  const sc_core::sc_time period_;
  const bool level_ = true;
  sc_core::sc_event edge_{"edge"};
};

}  // namespace csgsim::systemc
