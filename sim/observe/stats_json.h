// Converts the statistics of a run to JSON, the contents of its stats file.
// Used by sim.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string_view>

#include "hw/machines/machine.h"
#include "sim/engine/engine.h"
#include "sim/observe/knobs.h"
#include "sim/observe/stats.h"

namespace csgsim::observe {

/// The contents of a stats file of one run.
struct Report {
  const isa::Program& program;
  const machines::Machine& machine;
  std::string_view level;
  const engine::RunResult& result;
  const Stats& stats;
  double wall_seconds = 0;
  std::span<const Knob> knobs{};  ///< tried changes that help
};

/// The stats file; docs/settings.md describes every key with its unit.
nlohmann::ordered_json to_json(const Report& report);

/// Bits of pixel memory used by the Program's named fields.
std::uint32_t used_memory_bits(const isa::Program& program);

}  // namespace csgsim::observe
