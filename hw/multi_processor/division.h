#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <systemc>
#include <utility>
#include <vector>

#include "hw/isa/program.h"

namespace csgsim::multi_processor {

/// What dividing a segment finds and takes.
struct DividedSegment {
  std::uint64_t halfspace_tests = 0;  ///< half-spaces of the primitives that touch it
  std::uint64_t primitives = 0;       ///< active, whose data is broadcast; 0 only where all lists are empty
  std::uint64_t halfspaces = 0;       ///< whose data is broadcast
};

/// What dividing a subsegment finds and takes.
struct DividedSubsegment {
  std::uint64_t halfspaces = 0;  ///< of the primitives that touch it
  std::span<const isa::Instruction> list;
};

/// Where the parts that divide get what they find. `division.result` is ideal: what they find has been compiled by the
/// host, while the time that they take to find it is theirs.
class DivisionPort : virtual public sc_core::sc_interface {
 public:
  [[nodiscard]] virtual DividedSegment segment(std::span<const isa::Region> subsegments) const = 0;
  [[nodiscard]] virtual DividedSubsegment subsegment(const isa::Region& region) const = 0;
};

/// Finds it in the Program.
class Division final : public sc_core::sc_module, public DivisionPort {
 public:
  explicit Division(sc_core::sc_module_name name);

  /// The Program has to live until the frame is drawn.
  void begin(const isa::Program& program);

  [[nodiscard]] DividedSegment segment(std::span<const isa::Region> subsegments) const override;
  [[nodiscard]] DividedSubsegment subsegment(const isa::Region& region) const override;

  /// Which segment of the Program the subsegment is.
  [[nodiscard]] std::uint32_t number_of(const isa::Region& region) const { return numbers_.at({region.x, region.y}); }

 private:
  const isa::Program* program_ = nullptr;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> numbers_;  ///< by the region's top left
};

}  // namespace csgsim::multi_processor
