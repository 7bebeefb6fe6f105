#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "hw/machines/kind.h"
#include "hw/machines/machine.h"

namespace csgsim::test {

/// A machine of that kind with every parameter generated from the seed: one of its bounds, ideal if allowed, or a value
/// between. Bounds that would take a test minutes are tightened. Empty if the parameters are inconsistent.
std::optional<machines::Machine> random_machine(const machines::Kind& kind, std::uint64_t seed);

/// The machine's parameters as KEY=VALUE, in the format of `--set`.
std::string figures_of(const machines::Machine& machine);

}  // namespace csgsim::test
