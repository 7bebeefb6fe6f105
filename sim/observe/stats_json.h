#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string_view>

#include "hw/machines/machine.h"
#include "sim/engine/engine.h"
#include "sim/observe/knobs.h"
#include "sim/observe/stats.h"

namespace csgsim::observe {

/// All that a stats file tells of one run.
struct Report {
  const isa::Program& program;
  const machines::Machine& machine;
  std::string_view level;
  const engine::RunResult& result;
  const Stats& stats;
  double wall_seconds = 0;
  std::span<const Knob> knobs{};  ///< what was tried and helps
};

/// The stats file; docs/settings.md describes every key with its unit.
nlohmann::ordered_json to_json(const Report& report);

/// Bits of pixel memory that the Program's named fields take.
std::uint32_t used_memory_bits(const isa::Program& program);

}  // namespace csgsim::observe
