// Times of the host's pruning tests, which decide whether a test is worth its time.
// Used by host/emit and sim/session.
#pragma once

namespace csgsim::csg {

/// Time of the host and of the machine in nanoseconds. The default is a host that takes no time.
struct Prices {
  bool are_weighed = false;  ///< whether tests that are not worth their time are omitted (`--pruning auto`)
  double box = 0;            ///< comparison of two boxes
  double test = 0;           ///< test of a half-space at the corners of a rectangle
  double value = 0;          ///< comparison of the values of two planes
  double support = 0;        ///< evaluation of a point along a direction
  double instruction = 0;    ///< an instruction with an expression, including its execution by the machine

  /// Whether a test is worth its time: it takes `nanoseconds`, saves `instructions` if it succeeds, and is assumed to
  /// succeed in half of the cases.
  [[nodiscard]] bool is_worthwhile(double instructions, double nanoseconds) const {
    return !are_weighed || 2 * nanoseconds <= instructions * instruction;
  }

  bool operator==(const Prices&) const = default;
};

}  // namespace csgsim::csg
