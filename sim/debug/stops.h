#pragma once

#include <cstdint>
#include <optional>

#include "sim/debug/clocks.h"
#include "sim/debug/command.h"
#include "sim/engine/run.h"

namespace csgsim::debug {

/// Watches a run for one place to stop at, and says how far it can go without a look.
class Stop {
 public:
  /// From the run's place on. All have to outlive it, but for the target. Throws InputError for a target that the
  /// Program does not have, or a clock of a machine that does not tell.
  Stop(const Target& target, const isa::Program& program, const engine::Numbers& numbers, const engine::Run& run,
       Clocks& clocks);

  /// Whether a condition holds where the run is when the watch begins.
  [[nodiscard]] bool holds_already() const { return held_; }

  /// Whether it is an instruction or a clock that is not ahead of where the watch begins.
  [[nodiscard]] bool is_behind() const;

  /// Number of the next instruction before which reached() has to be asked; Run::end if there is none.
  [[nodiscard]] std::uint64_t next_look();

  /// Whether the run has to stop where it is.
  [[nodiscard]] bool reached();

 private:
  [[nodiscard]] std::uint64_t look_at_condition(const Condition& condition, std::uint64_t from) const;
  [[nodiscard]] std::uint64_t look_at_primitive(std::uint32_t primitive, std::uint64_t from) const;
  [[nodiscard]] bool begins(std::uint32_t primitive, std::uint64_t number) const;
  [[nodiscard]] bool is_met(const Condition& condition);

  Target target_;
  const isa::Program& program_;
  const engine::Numbers& numbers_;
  const engine::Run& run_;
  std::uint64_t begin_;                   ///< where the watch began
  std::uint64_t number_ = 0;              ///< of an instruction, or that of a clock
  std::uint64_t look_ = 0;                ///< the last answer of next_look
  std::optional<std::uint32_t> segment_;  ///< of the value before
  std::uint32_t value_ = 0;
  bool held_ = false;
};

}  // namespace csgsim::debug
