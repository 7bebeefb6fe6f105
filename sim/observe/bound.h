#pragma once

#include <optional>
#include <string>

#include "hw/machines/machine.h"
#include "sim/engine/engine.h"

namespace csgsim::observe {

/// The part of a machine that bounds how fast frames follow one another: it works in more of the clocks from one to the
/// next than any other does.
struct Bound {
  std::string part;
  double share = 0;      ///< of these clocks
  bool by_host = false;  ///< the host takes longer than these to compile the next frame
  std::string
      sentence;  ///< for people: frames per second, the part and its share, the next part, the host if it limits
};

/// From the account of a run; nothing where the machine's kind does not tell of its parts, or a frame takes no time.
std::optional<Bound> bound_of(const engine::RunResult& result, const machines::Machine& machine);

}  // namespace csgsim::observe
