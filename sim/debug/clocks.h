// Issue clocks of instructions, computed on first use.
// Used by sim/debug and sim/viewer.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "hw/machines/timeline.h"
#include "sim/engine/numbers.h"

namespace csgsim::debug {

/// Clocks in which the instructions of a run are issued, computed on first use.
class Clocks {
 public:
  /// Both arguments must outlive this object.
  Clocks(const isa::Program& program, const machines::Machine& machine) : program_(program), machine_(machine) {}

  /// Clocks in which the instruction at that place is issued. Throws InputError for kinds of machines without a
  /// timeline.
  [[nodiscard]] machines::ClockSpan issue_span(engine::Place place);

  /// Number of the first instruction, from `first_number` on, that is not completely issued when the clock begins.
  /// Throws InputError as issue_span() does.
  [[nodiscard]] std::uint64_t first_not_issued(std::uint64_t clock, std::uint64_t first_number);

 private:
  const machines::Timeline& timeline();

  const isa::Program& program_;
  const machines::Machine& machine_;
  std::optional<machines::Timeline> timeline_;
};

}  // namespace csgsim::debug
