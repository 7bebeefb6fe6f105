// The unit that limits the frame rate.
// Used by sim/observe, sim/shell and sim/studies.
#pragma once

#include <optional>
#include <string>

#include "hw/machines/machine.h"
#include "sim/engine/engine.h"

namespace csgsim::observe {

/// The unit of a machine that limits the frame rate: it is busy in more of the clocks from one frame to the next than
/// any other unit.
struct Bottleneck {
  std::string part;
  double share = 0;      ///< fraction of these clocks
  bool by_host = false;  ///< the host takes longer than these clocks to compile the next frame
  std::string limit;     ///< the unit and its share, and the next unit: `limited by the scan-out (84 % of ...)`
  std::string sentence;  ///< frames per second, the limit, and the host if it takes longer
};

/// A frame rate for people, with four significant digits: `24.32`.
std::string rate_text(double frames_per_second);

/// Computed from the account of a run; nothing if the machine's kind reports no units, or if a frame takes no time.
std::optional<Bottleneck> find_bottleneck(const engine::RunResult& result, const machines::Machine& machine);

}  // namespace csgsim::observe
