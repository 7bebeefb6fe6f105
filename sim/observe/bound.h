#pragma once

#include <optional>
#include <string>

#include "hw/machines/machine.h"
#include "sim/engine/engine.h"

namespace csgsim::observe {

/// What bounds how fast frames follow one another: of the machine the part that works in more of the clocks from one to
/// the next than any other does, or its host, where that takes longer.
struct Bound {
  std::string part;      ///< of the machine, or `host`
  double share = 0;      ///< of these clocks
  std::string sentence;  ///< for people: the part, its share, the frames a second, the part that comes after it
  std::string fed_part;  ///< if the host keeps up: of the machine
  double fed_share = 0;  ///< of the machine's clocks from one frame to the next
};

/// From the account of a run; nothing where the machine's kind does not tell of its parts, or a frame takes no time.
std::optional<Bound> bound_of(const engine::RunResult& result, const machines::Machine& machine);

}  // namespace csgsim::observe
