#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "hw/machines/timeline.h"
#include "sim/engine/numbers.h"

namespace csgsim::debug {

/// When instructions of a run are issued, worked out when somebody asks first.
class Clocks {
 public:
  /// Both have to outlive it.
  Clocks(const isa::Program& program, const machines::Machine& machine) : program_(program), machine_(machine) {}

  /// Of the instruction there. Throws InputError for a kind of machine that does not tell.
  [[nodiscard]] machines::ClockSpan issued(engine::Place place);

  /// Number of the first instruction, from `from` on, of which something is still to be issued when the clock begins.
  /// Throws the same.
  [[nodiscard]] std::uint64_t first_after(std::uint64_t clock, std::uint64_t from);

 private:
  const machines::Timeline& timeline();

  const isa::Program& program_;
  const machines::Machine& machine_;
  std::optional<machines::Timeline> timeline_;
};

}  // namespace csgsim::debug
