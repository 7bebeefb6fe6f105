// Breakpoints and targets of a run.
// Used by session.h.
#pragma once

#include <cstdint>
#include <optional>

#include "sim/debug/clocks.h"
#include "sim/debug/command.h"
#include "sim/engine/run.h"

namespace csgsim::debug {

/// Watches a run for one breakpoint or target, and computes how far the run can advance before the next check.
class Stop {
 public:
  /// Starts watching at the run's place. All arguments but the target must outlive this object. Throws InputError for a
  /// target that the Program does not have, or a clock of a machine without a timeline.
  Stop(const Target& target, const isa::Program& program, const engine::Numbers& numbers, const engine::Run& run,
       Clocks& clocks);

  /// Whether the condition already holds at the start.
  [[nodiscard]] bool holds_already() const { return held_; }

  /// Whether the target is an instruction or a clock at or before the start.
  [[nodiscard]] bool is_behind() const;

  /// Number of the next instruction before which is_reached() must be called; Run::end if there is none.
  [[nodiscard]] std::uint64_t next_check();

  /// Whether the run must stop at its place.
  [[nodiscard]] bool is_reached();

 private:
  [[nodiscard]] std::uint64_t next_check_of_condition(const Condition& condition, std::uint64_t first_number) const;
  [[nodiscard]] std::uint64_t next_check_of_primitive(std::uint32_t primitive, std::uint64_t first_number) const;
  [[nodiscard]] bool is_first_of_primitive(std::uint32_t primitive, std::uint64_t number) const;
  [[nodiscard]] bool is_met(const Condition& condition);

  Target target_;
  const isa::Program& program_;
  const engine::Numbers& numbers_;
  const engine::Run& run_;
  std::uint64_t begin_;                   ///< start of the watch
  std::uint64_t number_ = 0;              ///< target instruction, or the one of a target clock
  std::uint64_t next_check_ = 0;          ///< last result of next_check
  std::optional<std::uint32_t> segment_;  ///< segment of the previous value
  std::uint32_t value_ = 0;
  bool held_ = false;
};

}  // namespace csgsim::debug
