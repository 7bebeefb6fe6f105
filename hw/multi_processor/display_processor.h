#pragma once

#include <cstdint>
#include <systemc>
#include <vector>

#include "hw/isa/program.h"
#include "hw/isa/wire.h"
#include "hw/machines/machine.h"
#include "hw/multi_processor/account.h"
#include "hw/multi_processor/bus_word.h"
#include "hw/multi_processor/division.h"
#include "hw/multi_processor/figures.h"
#include "hw/multi_processor/time_base.h"

namespace csgsim::multi_processor {

/// Transforms the half-spaces of the model, then for each segment holds all primitives against it, and the half-spaces
/// of those that touch it; waits until the nodes have done with the segment before, and broadcasts what is left. It
/// does not divide while the nodes work, unless it divides ahead.
class DisplayProcessor final : public sc_core::sc_module {
 public:
  sc_core::sc_in<BusLines> bus{"bus"};
  sc_core::sc_out<BusRequest> request{"request"};
  sc_core::sc_in<std::uint64_t> released{"released"};  ///< barriers
  sc_core::sc_port<DivisionPort> division{"division"};
  sc_core::sc_out<std::uint64_t> frames{"frames"};  ///< that are drawn

  DisplayProcessor(sc_core::sc_module_name name, const machines::Machine& machine);

  /// Draws a frame of the model from the next delta on.
  void begin(const std::vector<isa::Region>& segments, const isa::ModelFacts& model);

  [[nodiscard]] DisplayClocks account() const { return stays_.clocks(time_.now()); }
  /// Adds what it has done.
  void tell(FrameAccount& counted) const;

 private:
  void work();
  void draw();
  void spend(DisplayActivity activity, std::uint64_t clocks);
  DividedSegment divide(const std::vector<isa::Region>& parts);
  void broadcast(const isa::Region& segment, const DividedSegment& divided);
  void send(const isa::Command& command, bool last);
  void send_data(WordKind kind, std::uint64_t words);
  void send(const BusRequest& word);
  void wait_for_nodes();

  TimeBase time_;
  const Figures figures_;
  const isa::ArrayShape nodes_;
  const std::uint32_t bus_width_;
  std::vector<isa::Region> segments_;
  std::uint64_t primitives_ = 0;  ///< of the model
  std::uint64_t halfspaces_ = 0;
  std::uint64_t words_ = 0;     ///< sent, of all frames
  std::uint64_t barriers_ = 0;  ///< that the nodes come to with what they have been sent, of all frames
  std::uint64_t drawn_ = 0;
  sc_core::sc_event start_{"start"};

  std::uint64_t first_word_ = 0;  ///< sent before the frame
  std::uint64_t active_segments_ = 0;
  std::uint64_t box_tests_ = 0;
  std::uint64_t halfspace_tests_ = 0;
  std::uint64_t sent_primitives_ = 0;
  std::uint64_t sent_halfspaces_ = 0;
  StageClocks stages_;
  Stays<DisplayActivity, display_activity_names.size()> stays_;
};

}  // namespace csgsim::multi_processor
