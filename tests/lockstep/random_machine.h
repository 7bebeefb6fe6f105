#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "hw/machines/kind.h"
#include "hw/machines/machine.h"

namespace csgsim::test {

/// A machine of that kind whose every figure the seed makes up: at one of its ends, ideal where it may be, or anywhere
/// between. Ends that would take a test minutes are brought nearer. Nothing where the figures do not fit each other.
std::optional<machines::Machine> random_machine(const machines::Kind& kind, std::uint64_t seed);

/// Its figures, KEY=VALUE each, as `--set` takes them.
std::string figures_of(const machines::Machine& machine);

}  // namespace csgsim::test
