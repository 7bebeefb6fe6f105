#pragma once

#include <cstddef>
#include <cstdint>
#include <systemc>
#include <vector>

#include "hw/machines/machine.h"
#include "hw/multi_processor/node_state.h"
#include "hw/systemc/retirement.h"
#include "hw/systemc/segment_names.h"

namespace csgsim::multi_processor {

/// Port through which nodes report what they have executed.
class CollectorPort : virtual public sc_core::sc_interface {
 public:
  /// The state that a report after instruction `index` of the subsegment must contain.
  [[nodiscard]] virtual systemc::Keep required_after(const isa::Region& region, std::uint32_t index) = 0;
  /// Called for each instruction of the subsegment, in order.
  virtual void after_instruction(std::uint32_t node, NodeState state) = 0;
  virtual void after_subsegment(std::uint32_t node, const isa::Region& region, NodeState end) = 0;
  /// Called for a segment whose subsegments have no instructions.
  virtual void after_clear(const isa::Region& segment) = 0;
};

/// Collects the reports of the nodes for a subsegment, each at its own clock, and forwards them instruction by
/// instruction when all nodes have finished it. Not a hardware unit: takes no clock.
class Collector final : public sc_core::sc_module, public CollectorPort {
 public:
  sc_core::sc_port<systemc::RetirementPort> retirement{"retirement"};

  Collector(sc_core::sc_module_name name, const machines::Machine& machine, const systemc::SegmentNames& names);

  [[nodiscard]] systemc::Keep required_after(const isa::Region& region, std::uint32_t index) override;
  void after_instruction(std::uint32_t node, NodeState state) override;
  void after_subsegment(std::uint32_t node, const isa::Region& region, NodeState end) override;
  void after_clear(const isa::Region& segment) override;

 private:
  void report_subsegment(const isa::Region& region);

  const isa::ArrayShape nodes_;
  const bool branches_;
  const systemc::SegmentNames& names_;
  std::vector<std::vector<NodeState>> steps_;  ///< states by instruction, then by node
  std::vector<std::uint32_t> reported_;        ///< number of instructions, by node
  std::vector<NodeState> ends_;                ///< final states by node
  std::uint32_t ended_ = 0;                    ///< number of nodes that have finished the subsegment
};

}  // namespace csgsim::multi_processor
