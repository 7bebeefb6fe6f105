#pragma once

#include <cstdint>
#include <systemc>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/multi_processor/account.h"
#include "hw/multi_processor/barrier.h"
#include "hw/multi_processor/bus_word.h"
#include "hw/multi_processor/collector.h"
#include "hw/multi_processor/control_bus.h"
#include "hw/multi_processor/display_processor.h"
#include "hw/multi_processor/model_host.h"
#include "hw/multi_processor/node.h"
#include "hw/multi_processor/room_line.h"
#include "hw/multi_processor/stage_watch.h"
#include "hw/systemc/clocked_machine.h"
#include "hw/systemc/retirement.h"
#include "hw/systemc/segment_names.h"

namespace csgsim::multi_processor {

/// The whole machine (thesis fig. 7.6 without the high-speed channel):
///
///     host ─── display processor ─── control bus ─┬─ node 0,0   node 0,1  ...─┐
///                                                 ├─ node 1,0   node 1,1  ...─┤ barrier
///                                                 └─ ...                     ─┘
class MultiProcessor final : public sc_core::sc_module, public systemc::ClockedMachine {
 public:
  MultiProcessor(sc_core::sc_module_name name, const machines::Machine& machine);

  /// Draws a frame, until the nodes have rendered the last subsegment.
  systemc::RunReport run(const isa::Program& program, systemc::RunListener& listener) override;

  [[nodiscard]] std::vector<wave::Tap> taps(const isa::Program& program, const wave::Request& request) const override;

 private:
  void bind_masters();
  void begin(const isa::Program& program, systemc::RunListener& listener);
  void on_done();
  [[nodiscard]] FrameAccount frame_counts() const;
  [[nodiscard]] std::vector<std::uint32_t> picture_of(const isa::Program& program) const;

  const machines::Machine machine_;
  TimeBase time_;
  sc_core::sc_signal<HostWord> host_word_{"host_word"};
  sc_core::sc_vector<sc_core::sc_signal<BusRequest>> requests_;
  sc_core::sc_signal<BusLines> lines_{"lines"};
  sc_core::sc_vector<sc_core::sc_signal<std::uint64_t>> arrivals_;
  sc_core::sc_signal<std::uint64_t> gathered_{"gathered"};
  sc_core::sc_signal<std::uint64_t> released_{"released"};
  sc_core::sc_signal<std::uint64_t> frames_{"frames"};

  systemc::SegmentNames names_;
  ModelHost host_;
  DisplayProcessor display_;
  ControlBus bus_;
  Barrier barrier_;
  sc_core::sc_vector<Node> nodes_;
  RoomLine room_;
  StageWatch watch_;
  Collector collector_;
  systemc::Retirement retirement_{"retirement"};
};

}  // namespace csgsim::multi_processor
